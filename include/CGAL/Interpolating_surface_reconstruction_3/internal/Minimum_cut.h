// Copyright (c) 2026  The authors of Interpolating_surface_reconstruction_3.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s) : The authors of Interpolating_surface_reconstruction_3

#ifndef CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MINIMUM_CUT_H
#define CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MINIMUM_CUT_H

#include <CGAL/license/Interpolating_surface_reconstruction_3.h>

// gcc cannot tell that the iterators in these headers are set before they are read.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
// Before the graph, whose header declares a get() that hides the one this needs.
#include <boost/pending/disjoint_sets.hpp>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Two labels for some nodes, with the least sum of what nodes pay for their labels and pairs of nodes for
// different ones. Graphs may have millions of nodes: arcs lie in flat arrays.
class Minimum_cut
{
public:
  using Node = std::uint32_t;

  // What two nodes pay if only the first is inside: not negative, but for rounding. Costs are in memory together with
  // the graph, so that they are short.
  struct Pair_cost
  {
    Node inside, outside;
    float cost;
  };

  // `inside_costs` has what each node pays for label inside more than for outside.
  Minimum_cut(const std::vector<float>& inside_costs, const std::vector<Pair_cost>& pairs)
    : m_inside(static_cast<Node>(inside_costs.size())), m_outside(m_inside + 1)
  {
    find_unit(inside_costs, pairs);
    connect(inside_costs, pairs);
    set_capacities(inside_costs, pairs);
  }

  // Of each node, 1 inside: as few are inside as can be. `cancellation_point()` is called again and again
  // and may throw.
  template <typename Cancellation_point>
  std::vector<unsigned char> operator()(Cancellation_point& cancellation_point)
  {
    const std::size_t size = num_vertices(m_graph);
    std::vector<Arc> predecessors(size);
    std::vector<boost::default_color_type> colors(size);
    std::vector<std::uint32_t> distances(size);
    // The search asks for the index of every node that it comes to.
    const auto index = boost::make_function_property_map<Node>([&cancellation_point](Node v) {
      cancellation_point();
      return v;
    });
    const auto plain_index = get(boost::vertex_index, m_graph);
    const auto capacities = boost::make_iterator_property_map(m_capacities.begin(), get(boost::edge_index, m_graph));
    const auto reverse = boost::make_function_property_map<Arc>(
      [this](const Arc& arc) { return Arc(target(arc, m_graph), m_reverse[arc.idx]); });
    boost::boykov_kolmogorov_max_flow(
      m_graph, capacities, capacities, reverse, boost::make_iterator_property_map(predecessors.begin(), plain_index),
      boost::make_iterator_property_map(colors.begin(), plain_index),
      boost::make_iterator_property_map(distances.begin(), plain_index), index, m_inside, m_outside);
    std::vector<unsigned char> is_inside(m_inside);
    for (Node k = 0; k != m_inside; ++k)
      is_inside[k] = colors[k] == colors[m_inside] ? 1 : 0;
    return is_inside;
  }

private:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                   boost::no_property, Node, std::uint32_t>;
  using Arc = boost::graph_traits<Graph>::edge_descriptor;

  // Rounded residuals would add up to flows that no arc can carry.
  using Capacity = std::int64_t;

  // All capacities together are less than two to this power: no flow overflows.
  static constexpr int CAPACITY_BITS = 62;

  // A power of two, so that the scale of the costs does not matter.
  void find_unit(const std::vector<float>& inside_costs, const std::vector<Pair_cost>& pairs)
  {
    double total = 0.;
    for (float cost : inside_costs)
      total += std::abs(double(cost));
    for (const Pair_cost& p : pairs)
      total += std::abs(double(p.cost));
    std::frexp(total, &m_exponent);
  }

  Capacity scaled(double cost) const
  {
    return static_cast<Capacity>(std::ldexp((std::max)(cost, 0.), CAPACITY_BITS - m_exponent));
  }

  // Calls visit(arc, reverse, from, to, capacity, reverse capacity) for each arc and its reverse. Arcs are in
  // the order of their sources; `next` has the first one of each.
  template <typename Visit>
  void for_each_arc(const std::vector<float>& inside_costs, const std::vector<Pair_cost>& pairs,
                    std::vector<std::uint32_t> next, const Visit& visit) const
  {
    const auto add = [&](Node from, Node to, Capacity capacity, Capacity reverse_capacity) {
      const std::uint32_t arc = next[from]++, reverse = next[to]++;
      visit(arc, reverse, from, to, capacity, reverse_capacity);
    };
    for (Node k = 0; k != m_inside; ++k)
      if (inside_costs[k] < 0.f)
        add(m_inside, k, scaled(-inside_costs[k]), 0);
      else
        add(k, m_outside, scaled(inside_costs[k]), 0);
    for (const Pair_cost& p : pairs)
      add(p.inside, p.outside, scaled(p.cost), 0);
  }

  void connect(const std::vector<float>& inside_costs, const std::vector<Pair_cost>& pairs)
  {
    m_first.assign(std::size_t(m_outside) + 2, 0);
    for_each_arc(inside_costs, pairs, std::vector<std::uint32_t>(m_first.size(), 0),
                 [this](std::uint32_t, std::uint32_t, Node from, Node to, Capacity, Capacity) {
                   ++m_first[from + 1];
                   ++m_first[to + 1];
                 });
    for (std::size_t v = 1; v != m_first.size(); ++v)
      m_first[v] += m_first[v - 1];
    std::vector<std::pair<Node, Node> > arcs(m_first.back());
    for_each_arc(inside_costs, pairs, m_first,
                 [&](std::uint32_t arc, std::uint32_t reverse, Node from, Node to, Capacity, Capacity) {
                   arcs[arc] = { from, to };
                   arcs[reverse] = { to, from };
                 });
    m_graph = Graph(boost::edges_are_sorted, arcs.begin(), arcs.end(), m_outside + 1);
  }

  void set_capacities(const std::vector<float>& inside_costs, const std::vector<Pair_cost>& pairs)
  {
    m_capacities.resize(m_first.back());
    m_reverse.resize(m_first.back());
    for_each_arc(inside_costs, pairs, std::move(m_first),
                 [this](std::uint32_t arc, std::uint32_t reverse, Node, Node, Capacity c, Capacity reverse_c) {
                   m_capacities[arc] = c;
                   m_capacities[reverse] = reverse_c;
                   m_reverse[arc] = reverse;
                   m_reverse[reverse] = arc;
                 });
  }

  const Node m_inside, m_outside; // the labels as nodes, after the others
  int m_exponent = 0;
  std::vector<std::uint32_t> m_first; // arc of each node, while the graph is made
  Graph m_graph;
  std::vector<Capacity> m_capacities; // those left, while the flow is being searched
  std::vector<std::uint32_t> m_reverse;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MINIMUM_CUT_H
