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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

namespace CGAL {
namespace Interpolating_surface_reconstruction_3 {
namespace internal {

// Two labels for some nodes, each in at most four pairs as a cell is, with the least sum of what nodes pay for their
// labels and pairs for different ones. Flow is pushed along paths between two trees that grow from nodes that want to
// be inside and outside, and are mended where paths are saturated (Boykov and Kolmogorov, An experimental comparison of
// min-cut/max-flow algorithms for energy minimization in vision, 2004). Graphs may have millions of nodes: all of a
// node lies together.
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
    : m_nodes(inside_costs.size())
  {
    find_unit(inside_costs, pairs);
    for (std::size_t v = 0; v != m_nodes.size(); ++v)
      m_nodes[v].terminal = scaled(-double(inside_costs[v]));
    for (const Pair_cost& p : pairs)
      connect(p);
  }

  // Of each node, 1 inside: as few are inside as can be. `cancellation_point()` is called again and again
  // and may throw.
  template <typename Cancellation_point>
  std::vector<unsigned char> operator()(Cancellation_point&& cancellation_point)
  {
    plant_trees();
    for (std::vector<Node> active; !m_active.empty();) {
      active.swap(m_active);
      for (Node v : active) {
        cancellation_point();
        m_nodes[v].is_active = false;
        Arc bridge;
        while (m_nodes[v].tree != FREE && grow(v, bridge)) {
          push_flow(bridge);
          mend(cancellation_point);
        }
      }
      active.clear();
    }
    std::vector<unsigned char> is_inside(m_nodes.size());
    for (std::size_t v = 0; v != m_nodes.size(); ++v)
      is_inside[v] = m_nodes[v].tree == INSIDE ? 1 : 0;
    return is_inside;
  }

private:
  // Rounded residuals would add up to flows that no arc can carry.
  using Capacity = std::int64_t;

  // All capacities together are less than two to this power: no flow overflows.
  static constexpr int CAPACITY_BITS = 62;

  enum Tree : unsigned char
  {
    FREE,
    INSIDE,
    OUTSIDE
  };

  // What a node of a tree has in place of the number of an arc to its parent.
  static constexpr unsigned char ROOT = 4, ORPHAN = 5;

  static constexpr std::size_t NO_ARC = 4;

  static constexpr std::uint32_t FAR = static_cast<std::uint32_t>(-1);

  struct Node_state
  {
    std::array<Capacity, 4> capacities{ { 0, 0, 0, 0 } }; // left, to the neighbors
    Capacity terminal = 0;                                // left: from the source if positive, else to the sink
    std::array<Node, 4> neighbors{ { 0, 0, 0, 0 } };
    std::array<unsigned char, 4> reverses{ { 0, 0, 0, 0 } }; // which neighbors of its neighbors it is
    std::uint32_t distance = 0;                              // from the root, as far as known at the time
    std::uint32_t time = 0;
    unsigned char degree = 0;
    Tree tree = FREE;
    unsigned char parent = ORPHAN;
    bool is_active = false;
  };

  struct Arc
  {
    Node node;
    std::size_t i;
  };

  // A power of two, so that the scale of the costs does not matter.
  void find_unit(const std::vector<float>& inside_costs, const std::vector<Pair_cost>& pairs)
  {
    double total = 0.;
    for (float cost : inside_costs)
      total += std::abs(double(cost));
    for (const Pair_cost& p : pairs)
      total += std::abs(double(p.cost));
    int exponent;
    std::frexp(total, &exponent);
    m_unit = std::ldexp(1., CAPACITY_BITS - exponent);
  }

  Capacity scaled(double cost) const { return static_cast<Capacity>(cost * m_unit); }

  void connect(const Pair_cost& p)
  {
    Node_state &a = m_nodes[p.inside], &b = m_nodes[p.outside];
    const unsigned char i = a.degree++, j = b.degree++;
    a.capacities[i] = scaled((std::max)(double(p.cost), 0.));
    a.neighbors[i] = p.outside;
    a.reverses[i] = j;
    b.neighbors[j] = p.inside;
    b.reverses[j] = i;
  }

  // Paths over one node are flow from the beginning: a node has one terminal.
  void plant_trees()
  {
    for (Node v = 0; v != m_nodes.size(); ++v)
      if (m_nodes[v].terminal != 0) {
        m_nodes[v].tree = m_nodes[v].terminal > 0 ? INSIDE : OUTSIDE;
        m_nodes[v].parent = ROOT;
        m_nodes[v].distance = 1;
        activate(v);
      }
  }

  void activate(Node v)
  {
    if (m_nodes[v].is_active)
      return;
    m_nodes[v].is_active = true;
    m_active.push_back(v);
  }

  // What is left of the arc between a node of a tree and its child, in the direction of the flow.
  Capacity& capacity(Tree tree, const Arc& to_child)
  {
    Node_state& state = m_nodes[to_child.node];
    return tree == INSIDE ? state.capacities[to_child.i]
                          : m_nodes[state.neighbors[to_child.i]].capacities[state.reverses[to_child.i]];
  }

  Node parent(Node v) const { return m_nodes[v].neighbors[m_nodes[v].parent]; }

  // Adds the free neighbors of v to its tree; stops at an arc from the inside tree to the outside one that
  // can carry flow, and returns true.
  bool grow(Node v, Arc& bridge)
  {
    const Node_state& state = m_nodes[v];
    for (std::size_t i = 0; i != state.degree; ++i) {
      if (capacity(state.tree, Arc{ v, i }) == 0)
        continue;
      const Node n = state.neighbors[i];
      Node_state& neighbor = m_nodes[n];
      if (neighbor.tree == FREE) {
        neighbor.tree = state.tree;
        set_parent(n, state.reverses[i], state);
        activate(n);
      } else if (neighbor.tree != state.tree) {
        bridge = state.tree == INSIDE ? Arc{ v, i } : Arc{ n, state.reverses[i] };
        return true;
      } else if (neighbor.time <= state.time && neighbor.distance > state.distance) {
        set_parent(n, state.reverses[i], state); // shorter paths are followed sooner
      }
    }
    return false;
  }

  void set_parent(Node child, unsigned char i, const Node_state& parent)
  {
    m_nodes[child].parent = i;
    m_nodes[child].time = parent.time;
    m_nodes[child].distance = parent.distance + 1;
  }

  void push_flow(const Arc& bridge)
  {
    Node_state& inside = m_nodes[bridge.node];
    const Node end = inside.neighbors[bridge.i];
    Capacity flow = inside.capacities[bridge.i];
    flow = (std::min)(flow, capacity_to_root(bridge.node));
    flow = (std::min)(flow, capacity_to_root(end));
    inside.capacities[bridge.i] -= flow;
    m_nodes[end].capacities[inside.reverses[bridge.i]] += flow;
    push_to_root(bridge.node, flow);
    push_to_root(end, flow);
  }

  Arc arc_from_parent(Node v) const
  {
    const Node_state& state = m_nodes[v];
    return Arc{ state.neighbors[state.parent], state.reverses[state.parent] };
  }

  Capacity capacity_to_root(Node v)
  {
    Capacity result = (std::numeric_limits<Capacity>::max)();
    for (; m_nodes[v].parent != ROOT; v = parent(v))
      result = (std::min)(result, capacity(m_nodes[v].tree, arc_from_parent(v)));
    return (std::min)(result, std::abs(m_nodes[v].terminal));
  }

  // Nodes behind a saturated arc become orphans.
  void push_to_root(Node v, Capacity flow)
  {
    while (m_nodes[v].parent != ROOT) {
      Node_state& state = m_nodes[v];
      const Arc arc = arc_from_parent(v);
      Capacity &down = m_nodes[arc.node].capacities[arc.i], &up = state.capacities[state.parent];
      (state.tree == INSIDE ? down : up) -= flow;
      (state.tree == INSIDE ? up : down) += flow;
      if ((state.tree == INSIDE ? down : up) == 0)
        orphan(v);
      v = arc.node;
    }
    m_nodes[v].terminal -= m_nodes[v].tree == INSIDE ? flow : -flow;
    if (m_nodes[v].terminal == 0)
      orphan(v);
  }

  void orphan(Node v)
  {
    m_nodes[v].parent = ORPHAN;
    m_orphans.push_back(v);
  }

  // Finds new parents for all orphans, or sets them free.
  template <typename Cancellation_point>
  void mend(Cancellation_point& cancellation_point)
  {
    ++m_time;
    for (std::size_t k = 0; k != m_orphans.size(); ++k) {
      cancellation_point();
      const Node v = m_orphans[k];
      const std::size_t i = find_parent(v);
      if (i == NO_ARC)
        set_free(v);
      else
        set_parent(v, static_cast<unsigned char>(i), m_nodes[m_nodes[v].neighbors[i]]);
    }
    m_orphans.clear();
  }

  // The arc to the neighbor nearest to a root.
  std::size_t find_parent(Node v)
  {
    const Node_state& state = m_nodes[v];
    std::size_t best = NO_ARC;
    std::uint32_t best_distance = FAR;
    for (std::size_t i = 0; i != state.degree; ++i) {
      const Node n = state.neighbors[i];
      if (m_nodes[n].tree != state.tree || capacity(state.tree, Arc{ n, state.reverses[i] }) == 0)
        continue;
      const std::uint32_t distance = distance_to_root(n);
      if (distance < best_distance) {
        best = i;
        best_distance = distance;
      }
    }
    return best;
  }

  // FAR if an orphan is on the way. Nodes on the way to a root remember their distance at this time.
  std::uint32_t distance_to_root(Node first)
  {
    std::uint32_t steps = 0;
    Node last = first;
    for (; m_nodes[last].time != m_time && m_nodes[last].parent != ROOT; last = parent(last), ++steps)
      if (m_nodes[last].parent == ORPHAN)
        return FAR;
    if (m_nodes[last].parent == ROOT) {
      m_nodes[last].time = m_time;
      m_nodes[last].distance = 1;
    }
    const std::uint32_t result = m_nodes[last].distance + steps;
    std::uint32_t distance = result;
    for (Node v = first; v != last; v = parent(v)) {
      m_nodes[v].time = m_time;
      m_nodes[v].distance = distance--;
    }
    return result;
  }

  // Its children become orphans; neighbors in the tree may take it back when they grow.
  void set_free(Node v)
  {
    Node_state& state = m_nodes[v];
    for (std::size_t i = 0; i != state.degree; ++i) {
      const Node n = state.neighbors[i];
      if (m_nodes[n].tree != state.tree)
        continue;
      if (capacity(state.tree, Arc{ n, state.reverses[i] }) != 0)
        activate(n);
      if (m_nodes[n].parent == state.reverses[i])
        orphan(n);
    }
    state.tree = FREE;
    state.parent = ORPHAN;
  }

  double m_unit = 1.; // of capacities
  std::vector<Node_state> m_nodes;
  std::vector<Node> m_active; // those that are still to grow
  std::vector<Node> m_orphans;
  std::uint32_t m_time = 0;
};

} // namespace internal
} // namespace Interpolating_surface_reconstruction_3
} // namespace CGAL

#endif // CGAL_INTERPOLATING_SURFACE_RECONSTRUCTION_3_INTERNAL_MINIMUM_CUT_H
