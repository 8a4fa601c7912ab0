// Points and structures for the tests of single stages. Assertions hold in every build mode.

#ifndef ISR_STAGE_TEST_UTILS_H
#define ISR_STAGE_TEST_UTILS_H

#undef NDEBUG
#include <cassert>

#include <CGAL/Interpolating_surface_reconstruction_3/Point_star.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Morton_order.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/Point_octree_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/local_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <vector>

namespace isr_stage_test {

namespace ISR = CGAL::Interpolating_surface_reconstruction_3;
using ISR::internal::Local_point;
using ISR::internal::Local_vector;
using ISR::internal::NO_POINT;
using ISR::internal::Point_index;
using ISR::internal::Point_octree_3;

constexpr std::uint32_t GAP = ISR::Point_star::GAP;

// Uniform numbers that are the same with every standard library.
class Random
{
public:
  explicit Random(std::uint32_t seed) : m_generator(seed) { }

  double operator()(double low, double high) { return low + (high - low) * (double(m_generator()) / 4294967296.); }

  std::size_t below(std::size_t n) { return m_generator() % n; }

  template <typename T>
  void shuffle(std::vector<T>& values)
  {
    for (std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[below(i)]);
  }

private:
  std::mt19937 m_generator;
};

inline std::vector<Local_point> random_box(std::size_t n, std::uint32_t seed)
{
  Random random(seed);
  std::vector<Local_point> result;
  for (std::size_t i = 0; i != n; ++i) {
    const double x = random(-1, 1), y = random(-1, 1), z = random(-1, 1);
    result.emplace_back(x, y, z);
  }
  return result;
}

// Fibonacci points on the unit sphere, moved by up to `noise` in each coordinate and put back.
inline std::vector<Local_point> sphere(std::size_t n, double noise, std::uint32_t seed)
{
  Random random(seed);
  std::vector<Local_point> result;
  for (std::size_t i = 0; i != n; ++i) {
    const double z = 1. - (2. * double(i) + 1.) / double(n), r = std::sqrt(1. - z * z);
    const double angle = 2.399963229728653 * double(i);
    const double dx = random(-noise, noise), dy = random(-noise, noise), dz = random(-noise, noise);
    const Local_vector v(r * std::cos(angle) + dx, r * std::sin(angle) + dy, z + dz);
    result.push_back(CGAL::ORIGIN + v / std::sqrt(v.squared_length()));
  }
  return result;
}

// An orthogonal frame that is parallel to no axis.
inline Local_point on_tilted_plane(double x, double y)
{
  const Local_vector u(2. / 3, 2. / 3, 1. / 3), v(-2. / 3, 1. / 3, 2. / 3);
  return CGAL::ORIGIN + u * x + v * y;
}

inline Local_vector tilted_plane_normal() { return Local_vector(1. / 3, -2. / 3, 2. / 3); }

// m * m points of the lattice with angles of 60 degrees and edges of length 1 / m.
inline std::vector<Local_point> hexagonal_patch(std::size_t m)
{
  std::vector<Local_point> result;
  for (std::size_t j = 0; j != m; ++j)
    for (std::size_t i = 0; i != m; ++i)
      result.push_back(
        on_tilted_plane((double(i) + (j % 2 == 1 ? .5 : 0.)) / double(m), double(j) * std::sqrt(.75) / double(m)));
  return result;
}

inline std::vector<Local_point> random_patch(std::size_t n, std::uint32_t seed)
{
  Random random(seed);
  std::vector<Local_point> result;
  for (std::size_t i = 0; i != n; ++i) {
    const double x = random(0, 1), y = random(0, 1);
    result.push_back(on_tilted_plane(x, y));
  }
  return result;
}

// m * m points with integer coordinates.
inline std::vector<Local_point> square_grid(std::size_t m)
{
  std::vector<Local_point> result;
  for (std::size_t j = 0; j != m; ++j)
    for (std::size_t i = 0; i != m; ++i)
      result.emplace_back(double(i), double(j), 0.);
  return result;
}

inline std::vector<Local_point> in_morton_order(const std::vector<Local_point>& points)
{
  const auto less = [&](Point_index i, Point_index j) {
    return points[i] < points[j] || (points[i] == points[j] && i < j);
  };
  std::vector<Local_point> result;
  for (Point_index i : ISR::internal::Morton_sorter<decltype(less)>(points, less)())
    result.push_back(points[i]);
  return result;
}

// Points in Morton order, coincident ones included, with their octree.
struct Indexed_points
{
  explicit Indexed_points(const std::vector<Local_point>& p) : points(in_morton_order(p)), octree(points) { }
  Indexed_points(const Indexed_points&) = delete;
  Indexed_points& operator=(const Indexed_points&) = delete;

  const std::vector<Local_point> points;
  const Point_octree_3 octree;
};

// The links of all stars, as indices of points or GAP, with the stars' normals and certainty.
struct Stars
{
  std::vector<std::vector<Point_index> > links;
  std::vector<Local_vector> normals;
  std::vector<bool> certain;

  bool is_closed(std::size_t p) const
  {
    return links[p].size() > 2 && std::count(links[p].begin(), links[p].end(), GAP) == 0;
  }

  // In how many stars of its vertices each triangle is.
  std::map<std::array<Point_index, 3>, int> votes() const
  {
    std::map<std::array<Point_index, 3>, int> result;
    for (std::size_t p = 0; p != links.size(); ++p)
      for (std::size_t i = 0; i != links[p].size(); ++i) {
        std::array<Point_index, 3> t = { Point_index(p), links[p][i], links[p][(i + 1) % links[p].size()] };
        std::sort(t.begin(), t.end());
        if (t[2] != GAP)
          ++result[t];
      }
    return result;
  }

  // The share of triangles that all of their three vertices have in their stars.
  double agreed_share() const
  {
    const std::map<std::array<Point_index, 3>, int> all = votes();
    std::size_t agreed = 0;
    for (const auto& v : all)
      agreed += v.second == 3 ? 1 : 0;
    return all.empty() ? 0. : double(agreed) / double(all.size());
  }
};

template <typename Neighborhoods, typename StarConstruction>
Stars construct_stars(const Indexed_points& indexed, const StarConstruction& construct)
{
  Stars result;
  result.links.resize(indexed.points.size());
  result.normals.resize(indexed.points.size());
  result.certain.resize(indexed.points.size());
  Neighborhoods neighborhoods(indexed.points, indexed.octree, std::numeric_limits<double>::infinity());
  ISR::Point_star star;
  for (std::uint32_t leaf : indexed.octree.leaves())
    neighborhoods.for_each_point(indexed.octree.node(leaf), StarConstruction::initial_number_of_neighbors(),
                                 StarConstruction::maximum_number_of_neighbors(),
                                 [&](Point_index p, const ISR::Star_neighborhood& neighborhood) {
                                   const bool is_certain = construct(neighborhood, star);
                                   result.links[p].clear();
                                   for (std::uint32_t i : star.link)
                                     result.links[p].push_back(i == GAP ? NO_POINT : neighborhoods.indices()[i]);
                                   result.normals[p] = star.normal;
                                   result.certain[p] = is_certain;
                                   return is_certain;
                                 });
  return result;
}

// Whether all triangles of a star turn counterclockwise about its normal.
inline bool is_counterclockwise(const Indexed_points& indexed, const Stars& stars, std::size_t p)
{
  const std::vector<Point_index>& link = stars.links[p];
  for (std::size_t i = 0; i != link.size(); ++i) {
    const Point_index u = link[i], v = link[(i + 1) % link.size()];
    if (u != GAP && v != GAP &&
        !(CGAL::cross_product(indexed.points[u] - indexed.points[p], indexed.points[v] - indexed.points[p]) *
            stars.normals[p] >
          0.))
      return false;
  }
  return true;
}

} // namespace isr_stage_test

#endif // ISR_STAGE_TEST_UTILS_H
