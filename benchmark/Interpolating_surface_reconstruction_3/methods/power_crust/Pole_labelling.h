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

#ifndef ISR_BENCHMARK_METHODS_POWER_CRUST_POLE_LABELLING_H
#define ISR_BENCHMARK_METHODS_POWER_CRUST_POLE_LABELLING_H

#include "poles.h"
#include "power_diagram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace isr_benchmark {
namespace power_crust {

// Labels polar balls inside or outside. Evidence spreads from the balls at the bounding box, best
// known first: two poles of a sample lie on different sides if they are seen in opposite directions,
// two neighbors of the power diagram on the same side if their balls overlap deeply.
class Pole_labelling
{
public:
  Pole_labelling(const std::vector<Point>& points, const Poles& poles, const Power_diagram& diagram)
    : m_points(points), m_poles(poles), m_diagram(diagram), m_evidence(poles.balls.size()),
      m_is_inside(poles.balls.size(), 0), m_samples(poles.balls.size())
  {
    for (std::size_t p = 0; p != poles.of_point.size(); ++p)
      for (std::size_t ball : poles.of_point[p])
        if (ball != NO_POLE)
          m_samples[ball].push_back(p);
  }

  std::vector<char> operator()()
  {
    for (std::size_t ball = 0; ball != m_evidence.size(); ++ball)
      m_queue.emplace(0., ball);
    for (std::size_t ball : m_poles.outer)
      support(ball, false, 1.);
    while (!m_queue.empty()) {
      const auto last = std::prev(m_queue.end());
      const std::size_t ball = last->second;
      m_queue.erase(last);
      label(ball);
    }
    return std::move(m_is_inside);
  }

private:
  struct Evidence
  {
    double inside = 0., outside = 0.;
    bool is_labelled = false;

    // Contradictory evidence is used last.
    double priority() const
    {
      return inside > 0. && outside > 0. ? std::abs(inside - outside) - 1. : (std::max)(inside, outside);
    }
  };

  void label(std::size_t ball)
  {
    Evidence& evidence = m_evidence[ball];
    evidence.is_labelled = true;
    const bool is_inside = evidence.inside > evidence.outside;
    m_is_inside[ball] = is_inside ? 1 : 0;
    const double confidence = (std::max)(evidence.inside, evidence.outside);
    for (std::size_t p : m_samples[ball]) {
      const std::array<std::size_t, 2>& pair = m_poles.of_point[p];
      const std::size_t other = pair[0] == ball ? pair[1] : pair[0];
      if (other != NO_POLE)
        support(other, !is_inside, confidence * opposition(m_points[p], ball, other));
    }
    for (std::size_t other : m_diagram.neighbors(ball))
      support(other, is_inside, confidence * overlap(ball, other));
  }

  void support(std::size_t ball, bool is_inside, double value)
  {
    Evidence& evidence = m_evidence[ball];
    double& known = is_inside ? evidence.inside : evidence.outside;
    if (evidence.is_labelled || value <= known)
      return;
    m_queue.erase({ evidence.priority(), ball });
    known = value;
    m_queue.emplace(evidence.priority(), ball);
  }

  double opposition(const Point& p, std::size_t a, std::size_t b) const
  {
    const Vector u = m_poles.balls[a].point() - p, v = m_poles.balls[b].point() - p;
    return -(u * v) / std::sqrt(u.squared_length() * v.squared_length());
  }

  // Cosine of the angle between the normals of the two spheres where they meet.
  double overlap(std::size_t a, std::size_t b) const
  {
    const auto& s = m_poles.balls[a];
    const auto& t = m_poles.balls[b];
    const double d = CGAL::squared_distance(s.point(), t.point());
    return (std::min)(1., (s.weight() + t.weight() - d) / (2. * std::sqrt(s.weight() * t.weight())));
  }

  const std::vector<Point>& m_points;
  const Poles& m_poles;
  const Power_diagram& m_diagram;
  std::vector<Evidence> m_evidence;
  std::vector<char> m_is_inside;
  std::vector<std::vector<std::size_t> > m_samples; // whose pole is the center of the ball
  std::set<std::pair<double, std::size_t> > m_queue;
};

} // namespace power_crust
} // namespace isr_benchmark

#endif // ISR_BENCHMARK_METHODS_POWER_CRUST_POLE_LABELLING_H
