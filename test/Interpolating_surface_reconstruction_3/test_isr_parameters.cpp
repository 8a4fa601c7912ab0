#include "isr_stage_test_utils.h"

#include <CGAL/Interpolating_surface_reconstruction_3/Restricted_voronoi_star_3.h>
#include <CGAL/Interpolating_surface_reconstruction_3/internal/parameter_check.h>
#include <CGAL/Interpolating_surface_reconstruction_3/parameters.h>

#include <CGAL/property_map.h>

#include <iostream>
#include <type_traits>

namespace np = CGAL::parameters;
namespace tags = CGAL::internal_np;
using CGAL::Interpolating_surface_reconstruction_3::Restricted_voronoi_star_3;
using CGAL::Interpolating_surface_reconstruction_3::internal::Only_allowed;
using CGAL::parameters::choose_parameter;
using CGAL::parameters::get_parameter;

struct Point_map
{
  int id;
};
struct Normal_map
{
  int id;
};
struct Star
{
  int id;
};

// What a function with defaults reads.
struct Values
{
  int hole_size;
  bool keeps_boundaries;
  int point_map, normal_map, star;
};

template <typename NamedParameters>
Values read(const NamedParameters& pack)
{
  const int hole_size = choose_parameter(get_parameter(pack, tags::maximum_hole_size), -1);
  const bool keeps = choose_parameter(get_parameter(pack, tags::keep_boundaries), false);
  const Point_map point_map = choose_parameter(get_parameter(pack, tags::point_map), Point_map{ -1 });
  const Normal_map normal_map = choose_parameter(get_parameter(pack, tags::normal_map), Normal_map{ -1 });
  const Star star = choose_parameter(get_parameter(pack, tags::star_construction), Star{ -1 });
  return Values{ hole_size, keeps, point_map.id, normal_map.id, star.id };
}

bool operator==(const Values& a, const Values& b)
{
  return a.hole_size == b.hole_size && a.keeps_boundaries == b.keeps_boundaries && a.point_map == b.point_map &&
         a.normal_map == b.normal_map && a.star == b.star;
}

void test_single_parameters()
{
  assert((read(np::default_values()) == Values{ -1, false, -1, -1, -1 }));
  assert((read(np::maximum_hole_size(64)) == Values{ 64, false, -1, -1, -1 }));
  assert((read(np::keep_boundaries(true)) == Values{ -1, true, -1, -1, -1 }));
  assert((read(np::star_construction(Star{ 7 })) == Values{ -1, false, -1, -1, 7 }));
  assert((read(np::point_map(Point_map{ 1 })) == Values{ -1, false, 1, -1, -1 }));
}

void test_chaining()
{
  assert((read(np::maximum_hole_size(64).point_map(Point_map{ 1 })) == Values{ 64, false, 1, -1, -1 }));
  assert((read(np::keep_boundaries(true).point_map(Point_map{ 1 }).normal_map(Normal_map{ 2 })) ==
          Values{ -1, true, 1, 2, -1 }));
}

void test_combine()
{
  assert((read(np::combine(np::maximum_hole_size(3))) == Values{ 3, false, -1, -1, -1 }));
  assert((read(np::combine(np::maximum_hole_size(3), np::keep_boundaries(true))) == Values{ 3, true, -1, -1, -1 }));
  assert((read(np::combine(np::default_values(), np::maximum_hole_size(3))) == Values{ 3, false, -1, -1, -1 }));
  assert((read(np::combine(np::maximum_hole_size(3), np::default_values())) == Values{ 3, false, -1, -1, -1 }));
  const auto maps = np::point_map(Point_map{ 1 }).normal_map(Normal_map{ 2 });
  const Values expected{ 3, true, 1, 2, 4 };
  assert(read(np::combine(maps, np::maximum_hole_size(3), np::keep_boundaries(true),
                          np::star_construction(Star{ 4 }))) == expected);
  assert(read(np::combine(np::star_construction(Star{ 4 }), np::keep_boundaries(true), np::maximum_hole_size(3),
                          maps)) == expected);
  assert(read(np::combine(np::maximum_hole_size(3).point_map(Point_map{ 1 }),
                          np::keep_boundaries(true).normal_map(Normal_map{ 2 }), np::star_construction(Star{ 4 }))) ==
         expected);
  // the result of combine() can be continued, and combined again
  assert(
    read(np::combine(np::combine(np::maximum_hole_size(3), np::keep_boundaries(true)), np::star_construction(Star{ 4 }))
           .point_map(Point_map{ 1 })
           .normal_map(Normal_map{ 2 })) == expected);
}

// A pack keeps its values when the packs that it was made of are gone.
auto make_pack()
{
  const int hole_size = 17;
  const auto first = np::maximum_hole_size(hole_size);
  const auto second = np::keep_boundaries(true).point_map(Point_map{ 5 });
  return np::combine(first, second);
}

template <typename... Tags, typename NamedParameters>
constexpr bool is_allowed(const NamedParameters&)
{
  return Only_allowed<NamedParameters, Tags...>::value;
}

void test_only_allowed()
{
  assert(is_allowed<>(np::default_values()));
  assert(is_allowed<tags::keep_boundaries_t>(np::keep_boundaries(true)));
  assert(!is_allowed<tags::keep_boundaries_t>(np::maximum_hole_size(3)));
  assert(!is_allowed<>(np::maximum_hole_size(3)));
  const auto maps = np::point_map(Point_map{ 1 }).normal_map(Normal_map{ 2 });
  assert((is_allowed<tags::normal_t, tags::point_t>(maps)));
  assert((!is_allowed<tags::point_t>(maps)));
  assert((!is_allowed<tags::normal_t>(maps)));
  const auto all = np::combine(maps, np::default_values(), np::maximum_hole_size(3));
  assert((is_allowed<tags::normal_t, tags::point_t, tags::maximum_hole_size_t>(all)));
  assert((!is_allowed<tags::normal_t, tags::point_t, tags::keep_boundaries_t>(all)));
  static_assert(Only_allowed<std::decay_t<decltype(np::default_values())> >::value, "no parameter is always allowed");
}

int main()
{
  test_single_parameters();
  test_chaining();
  test_combine();
  assert((read(make_pack()) == Values{ 17, true, 5, -1, -1 }));
  test_only_allowed();
  const Restricted_voronoi_star_3 star =
    choose_parameter(get_parameter(np::star_construction(Restricted_voronoi_star_3()), tags::star_construction),
                     Restricted_voronoi_star_3());
  assert(star.maximum_number_of_neighbors() >= star.initial_number_of_neighbors());
  std::cout << "done" << std::endl;
  return 0;
}
