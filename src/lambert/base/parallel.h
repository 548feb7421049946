#pragma once
#include <cstddef>
#include <functional>

namespace lambert {

/// Limits all parallel work of the process to `count` threads; 0 means one per hardware thread.
void set_thread_count(std::size_t count);
std::size_t thread_count();

/// Calls body(i) once for every i in [0, count), on several threads, in any order; returns when all are done. An
/// exception from a body ends the loop and is rethrown here. Bodies must not depend on each other.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace lambert
