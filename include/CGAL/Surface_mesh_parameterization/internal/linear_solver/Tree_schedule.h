// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_TREE_SCHEDULE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_TREE_SCHEDULE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_group.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal {

// Visits the nodes of a forest in postorder, children before parents or the other way round, independent subtrees
// at the same time. Small subtrees are one task, each node above them is one; all nodes are, if there is little work.
class Tree_schedule
{
public:
  Tree_schedule() = default;

  // `parent`: per node, a larger number, or -1. `work`: of each node, in operations.
  Tree_schedule(const std::vector<int>& parent, const std::vector<double>& work)
  {
    constexpr double number_of_shares = 64; // of the work; a task has at most one, unless it is a single node
    constexpr double little_work = 1e7;     // some milliseconds
    const int n = int(parent.size());
    if(std::accumulate(work.begin(), work.end(), 0.) < little_work)
    {
      m_tasks.push_back({0, n, -1, 0});
      return;
    }
    std::vector<double> total = work;
    std::vector<int> first(n); // of the subtree
    double whole = 0;
    for(int v = 0; v < n; ++v)
      first[v] = v;
    for(int v = 0; v < n; ++v)
    {
      whole += work[v];
      if(parent[v] < 0)
        continue;
      total[parent[v]] += total[v];
      first[parent[v]] = (std::min)(first[parent[v]], first[v]);
    }
    const auto is_small = [&](int v) { return total[v] * number_of_shares <= whole; };
    std::vector<int> task(n, -1);
    for(int v = 0; v < n; ++v)
      if(!is_small(v))
      {
        task[v] = int(m_tasks.size());
        m_tasks.push_back({v, v + 1, -1, 0});
      }
      else if(parent[v] < 0 || !is_small(parent[v]))
      {
        task[v] = int(m_tasks.size());
        m_tasks.push_back({first[v], v + 1, -1, 0});
      }
    for(int v = 0; v < n; ++v)
      if(task[v] >= 0 && parent[v] >= 0)
      {
        m_tasks[task[v]].parent = task[parent[v]];
        ++m_tasks[task[parent[v]]].number_of_children;
      }
  }

  // Calls `visit(v)` for all nodes, each after its children.
  template <typename Visit>
  void ascend(Execution execution, const Visit& visit) const
  {
    const auto run = [&](const Task& task)
    {
      for(int v = task.begin; v < task.end; ++v)
        visit(v);
    };
#ifdef CGAL_LINKED_WITH_TBB
    if(execution == Execution::PARALLEL && m_tasks.size() > 1)
    {
      std::vector<std::atomic<int> > missing(m_tasks.size());
      for(std::size_t t = 0; t < m_tasks.size(); ++t)
        missing[t] = m_tasks[t].number_of_children;
      // The thread that ends the last child goes on with the parent.
      const auto climb = [&](int t)
      {
        do
        {
          run(m_tasks[t]);
          t = m_tasks[t].parent;
        }
        while(t >= 0 && --missing[t] == 0);
      };
      execute_in_isolation(execution, [&]
      {
        tbb::task_group group;
        for(int t = 0; t < int(m_tasks.size()); ++t)
          if(m_tasks[t].number_of_children == 0)
            group.run([&climb, t] { climb(t); });
        group.wait();
      });
      return;
    }
#endif
    (void)execution;
    for(const Task& task : m_tasks)
      run(task);
  }

  // Calls `visit(v)` for all nodes, each after its parent.
  template <typename Visit>
  void descend(Execution execution, const Visit& visit) const
  {
    const auto run = [&](const Task& task)
    {
      for(int v = task.end - 1; v >= task.begin; --v)
        visit(v);
    };
#ifdef CGAL_LINKED_WITH_TBB
    if(execution == Execution::PARALLEL && m_tasks.size() > 1)
    {
      // The tasks of single nodes come first: all others hang on them.
      for(int t = int(m_tasks.size()) - 1; t >= 0; --t)
        if(m_tasks[t].number_of_children > 0)
          run(m_tasks[t]);
      execute(execution, int(m_tasks.size()), [&](int t)
      {
        if(m_tasks[t].number_of_children == 0)
          run(m_tasks[t]);
      });
      return;
    }
#endif
    (void)execution;
    for(int t = int(m_tasks.size()) - 1; t >= 0; --t)
      run(m_tasks[t]);
  }

private:
  struct Task
  {
    int begin, end; // nodes
    int parent;     // the task that waits for this one, -1 if none does
    int number_of_children;
  };

  std::vector<Task> m_tasks;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_TREE_SCHEDULE_H
