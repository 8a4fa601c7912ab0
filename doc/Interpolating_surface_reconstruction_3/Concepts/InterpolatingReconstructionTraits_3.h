/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Concepts
\cgalConcept

The concept `InterpolatingReconstructionTraits_3` lists the types, predicates and constructions that
the functions of this package use. For every functor type `Xxx_3` there is a `const` member function
`xxx_3_object()` that returns a functor. Every \cgal kernel is a model.

Decisions that change the topology of the surface and hang on geometry, such as whether a triangle is
degenerate, are made by the predicates. With exact predicates they are exact. Measures that only rank
candidates are computed in `double`.

\cgalHasModelsBegin
\cgalHasModelsBare{Any model of `Kernel`, in particular `CGAL::Exact_predicates_inexact_constructions_kernel`}
\cgalHasModelsEnd
*/
class InterpolatingReconstructionTraits_3
{
public:
  /// \name Types
  /// @{

  /// a model of `FieldNumberType` and `RealEmbeddable`.
  typedef unspecified_type FT;
  /// point; `DefaultConstructible`, `CopyConstructible` and `Assignable`.
  typedef unspecified_type Point_3;
  /// vector; `DefaultConstructible`, `CopyConstructible` and `Assignable`.
  typedef unspecified_type Vector_3;

  /// @}

  /// \name Predicates
  /// @{

  /// `bool operator()(Point_3 p, Point_3 q)`: whether `p` and `q` are equal.
  typedef unspecified_type Equal_3;
  /// `bool operator()(Point_3 p, Point_3 q)`: whether `p` precedes `q` lexicographically.
  typedef unspecified_type Less_xyz_3;
  /// `bool operator()(Point_3 p, Point_3 q, Point_3 r)`: whether the points lie on a line.
  typedef unspecified_type Collinear_3;
  /// `Orientation operator()(Point_3 p, Point_3 q, Point_3 r)` and the same with a fourth point `s`,
  /// as in `Kernel::CoplanarOrientation_3`.
  typedef unspecified_type Coplanar_orientation_3;
  /// `Orientation operator()(Point_3 p, Point_3 q, Point_3 r, Point_3 s)`: the side of the plane
  /// through `p`, `q` and `r` on which `s` lies.
  typedef unspecified_type Orientation_3;
  /// `Comparison_result operator()(Point_3 p, Point_3 q, FT d)` and
  /// `Comparison_result operator()(Point_3 p, Point_3 q, Point_3 r, Point_3 s)`: compares the squared
  /// distance of `p` and `q` with `d` or with that of `r` and `s`.
  typedef unspecified_type Compare_squared_distance_3;

  /// @}

  /// \name Constructions
  /// @{

  /// `Vector_3 operator()(Point_3 p, Point_3 q)`: the vector from `p` to `q`;
  /// `Vector_3 operator()(FT x, FT y, FT z)`.
  typedef unspecified_type Construct_vector_3;
  /// `Point_3 operator()(FT x, FT y, FT z)`.
  typedef unspecified_type Construct_point_3;
  /// `Point_3 operator()(Point_3 p, Vector_3 v)`.
  typedef unspecified_type Construct_translated_point_3;
  /// `Vector_3 operator()(Vector_3 v, FT factor)`.
  typedef unspecified_type Construct_scaled_vector_3;
  /// `Vector_3 operator()(Vector_3 v, Vector_3 w)`.
  typedef unspecified_type Construct_sum_of_vectors_3;
  /// `Vector_3 operator()(Vector_3 v, Vector_3 w)`.
  typedef unspecified_type Construct_cross_product_vector_3;
  /// `Bbox_3 operator()(Point_3 p)`.
  typedef unspecified_type Construct_bbox_3;
  /// an iterator over the coordinates of a point or vector: `operator()(p)` begins, `operator()(p, 0)`
  /// ends.
  typedef unspecified_type Construct_cartesian_const_iterator_3;

  /// @}

  /// \name Computations
  /// @{

  /// `FT operator()(Point_3 p, Point_3 q)`.
  typedef unspecified_type Compute_squared_distance_3;
  /// `FT operator()(Vector_3 v)`.
  typedef unspecified_type Compute_squared_length_3;
  /// `FT operator()(Vector_3 v, Vector_3 w)`.
  typedef unspecified_type Compute_scalar_product_3;
  /// `FT operator()(Vector_3 u, Vector_3 v, Vector_3 w)`.
  typedef unspecified_type Compute_determinant_3;

  /// @}
};
