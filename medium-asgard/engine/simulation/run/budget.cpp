#include "run/budget.h"

#include <atomic>

namespace simulation {
namespace {

std::atomic<std::size_t> most = usualBytes;

} // namespace

std::size_t mostBytes() { return most; }
void setMostBytes(std::size_t bytes) { most = bytes; }

} // namespace simulation
