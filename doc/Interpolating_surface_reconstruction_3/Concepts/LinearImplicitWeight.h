/*!
\ingroup PkgInterpolatingSurfaceReconstruction3Concepts
\cgalConcept

The concept `LinearImplicitWeight` describes how much the tangent plane at a sample counts in a
`CGAL::Interpolating_surface_reconstruction_3::Linear_implicit_function_3`.

A weight depends on two numbers. The *ratio* is the square of the distance of the point of evaluation from
the sample over the square of the distance at which the weight ends, from 0 to less than 1. The
*agreement* is the scalar product of the normals of the sample and of the sample nearest to the point of
evaluation, from -1 to 1.

A model can be copied and be constructed without arguments.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Interpolating_surface_reconstruction_3::Interpolating_weight}
\cgalHasModels{CGAL::Interpolating_surface_reconstruction_3::Quadratic_weight}
\cgalHasModelsEnd
*/
class LinearImplicitWeight
{
public:
  /// returns the distance at which the weight of a sample ends, as a multiple of the mean distance of the
  /// sample to the neighbors in its star.
  double support() const;

  /// returns the weight, not negative. If it grows without bound as the ratio goes to 0, the function
  /// interpolates.
  double operator()(double ratio, double agreement) const;

  /// returns the derivative of the weight with respect to the ratio.
  double derivative(double ratio, double agreement) const;
};
