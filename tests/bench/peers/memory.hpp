#pragma once

#include <cstddef>
#include <string>

namespace tuftwave::bench {

/// What the memory allows: the same number of bytes set and copied where they have been before, and written for the
/// first time. Prints WORK/memset, WORK/memcpy and WORK/fresh_write.
void measure_memory(const std::string& work, std::size_t bytes);

}  // namespace tuftwave::bench
