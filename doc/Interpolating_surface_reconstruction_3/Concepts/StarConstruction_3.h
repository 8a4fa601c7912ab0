/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Concepts
\cgalConcept

The concept `StarConstruction_3` describes how the star of a point is found: the triangles that a
surface through the point would have there, seen from this point alone.

A model is used by several threads at once and through `const` references. It sees neighbors as
vectors from the point, in double precision and in a unit of the cloud's own, so that its result
must not depend on a length being large or small in absolute terms. Two calls with the same
neighborhood must give the same star.

A triangle is taken at once if the stars of its three vertices have it, so the surface is the better
the more the stars of neighboring points agree. Choices that depend on what only one of the points
sees, such as a diagonal chosen in its tangent plane, should be avoided.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Interpolating_surface_reconstruction_3::Restricted_voronoi_star_3}
\cgalHasModels{CGAL::Interpolating_surface_reconstruction_3::Regularity_star_3}
\cgalHasModelsEnd

\sa `CGAL::ctc_reconstruction()`
\sa `CGAL::pcr_reconstruction()`
*/
class StarConstruction_3
{
public:
  /// \name Types
  /// @{

  /*!
  how the neighbors are gathered:
  `CGAL::Interpolating_surface_reconstruction_3::Nearest_neighborhood_tag` or
  `CGAL::Interpolating_surface_reconstruction_3::Box_neighborhood_tag`.
  */
  typedef unspecified_type Neighborhood_category;

  /// @}

  /// \name Operations
  /// @{

  /*!
  returns the number of nearest neighbors to begin with. Only required if `Neighborhood_category` is
  `CGAL::Interpolating_surface_reconstruction_3::Nearest_neighborhood_tag`.
  */
  static std::size_t initial_number_of_neighbors();

  /*!
  returns the largest number of nearest neighbors worth looking at, which ends the search where
  no star becomes certain. Only required if `Neighborhood_category` is
  `CGAL::Interpolating_surface_reconstruction_3::Nearest_neighborhood_tag`.
  */
  static std::size_t maximum_number_of_neighbors();

  /*!
  replaces `star` by the star of the center of `neighborhood`, and returns whether no point outside
  of the neighborhood could change it. If it returns `false`, it is called again with more neighbors
  as long as there are any and their number does not exceed `maximum_number_of_neighbors()`; the last
  star counts. As long as `neighborhood.may_grow()`, a star need not be made for which it returns `false`. It
  may as well return `true` because more neighbors are not worth looking at. A star may be empty or have gaps.
  If `neighborhood.keeps_boundaries()`, it is to end at openings of the surface, in place of reaching across
  them.
  \param neighborhood the neighbors by increasing distance.
  \param star the result; buffers that it holds may be used again.
  */
  bool operator()(const CGAL::Interpolating_surface_reconstruction_3::Star_neighborhood& neighborhood,
                  CGAL::Interpolating_surface_reconstruction_3::Point_star& star) const;

  /// @}
};
