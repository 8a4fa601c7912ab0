/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Concepts
\cgalConcept

The concept `InterpolatingReconstructionVisitor` describes an object that is told what a
reconstruction does and may end it. Pass `std::ref(visitor)` to keep its state, as the parameter is
taken by value.

All functions but `go_further()` are called by the thread that called the reconstruction.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Interpolating_surface_reconstruction_3::Default_visitor}
\cgalHasModelsEnd

\sa `CGAL::ctc_reconstruction()`
\sa `CGAL::pcr_reconstruction()`
\sa `CGAL::lis_reconstruction()`
*/
class InterpolatingReconstructionVisitor
{
public:
  /*!
  is called first.
  \param number_of_points the size of the input range.
  */
  void on_reconstruction_begin(std::size_t number_of_points);

  /*!
  is called once, after the points were read.
  \param duplicates number of points that are set aside because they equal an earlier one, or coincide
  with another one in double precision once the longest side of the bounding box is scaled to about 1.
  \param non_finite number of points with a coordinate that is not a finite number or, for
  `lis_reconstruction()`, with a normal that is zero or not finite.
  */
  void on_points_set_aside(std::size_t duplicates, std::size_t non_finite);

  /*!
  is called when a stage begins.
  \param stage the stage.
  */
  void on_stage_begin(CGAL::Interpolating_surface_reconstruction_3::Stage stage);

  /*!
  is polled; `false` cancels the reconstruction. With `CGAL::Parallel_tag`, it is called by worker
  threads too, but never by two at once.
  */
  bool go_further();

  /*!
  is called for every triangle that is proposed where the stars do not agree; during `Stage::GROWING`, for
  the triangles on which they agree as well, in the order in which they are attached; those that grow from
  one seed are oriented consistently.
  \param triangle positions in the input range.
  \param verdict what happened to the triangle.
  */
  void on_triangle(const std::array<std::size_t, 3>& triangle,
                   CGAL::Interpolating_surface_reconstruction_3::Triangle_verdict verdict);

  /*!
  is called when a stage ends.
  \param stage the stage.
  \param items the number of its results: points, stars, triangles, or loops.
  */
  void on_stage_end(CGAL::Interpolating_surface_reconstruction_3::Stage stage, std::size_t items);

  /*!
  is called before the end, unless the reconstruction is cancelled.
  \param unused number of distinct finite points that no triangle uses.
  */
  void on_points_unused(std::size_t unused);

  /*!
  is called last.
  \param cancelled whether the reconstruction was cancelled.
  */
  void on_reconstruction_end(bool cancelled);
};
