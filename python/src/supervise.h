// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Runs the library while Python stays responsive.

#ifndef SURFACE_MESH_CUTTING_PYTHON_SUPERVISE_H
#define SURFACE_MESH_CUTTING_PYTHON_SUPERVISE_H

#include "Run_monitor.h"
#include "conversions.h"

#include <functional>

namespace binding {

// Calls `work(monitor)`, which must not touch Python, in a thread of its own with the call's "threads" and "time_limit",
// while the calling thread handles signals and calls "progress". Exceptions of all three pass, after the work has ended.
// The first KeyboardInterrupt only stops the work.
// Returns whether there was one.
bool supervise(const Call& call, const std::function<void(Run_monitor&)>& work);

// Ends the calls of all other threads, before the interpreter ends: it would kill a thread that waits for its lock, and with it
// the process. No call of another thread begins any more.
void stop_all_calls();

// In a process that was forked: the threads of these calls are in the other one.
void forget_calls();

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_SUPERVISE_H
