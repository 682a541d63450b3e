#pragma once

#include <cstdint>

namespace vestige::importer {

/// What this process may not exceed, set before anything of the file is seen: address space, processor time,
/// no files written, no core dump; it ends with its parent. Under a sanitizer the address space stays free.
void limitProcess(std::uint64_t memoryBytes, std::uint64_t seconds);

/// From here on no new program, no socket, no file opened by its name, no other process touched; such calls
/// fail (seccomp). For after the libraries are loaded.
void closeDoors();

}  // namespace vestige::importer
