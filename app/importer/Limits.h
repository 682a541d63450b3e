#pragma once

#include <cstdint>

namespace vestige::importer {

/// A sanitizer, which cannot run under these limits, is built in.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define VESTIGE_SANITIZED true
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define VESTIGE_SANITIZED true
#endif
#endif
#ifndef VESTIGE_SANITIZED
#define VESTIGE_SANITIZED false
#endif
inline constexpr bool kSanitized = VESTIGE_SANITIZED;
#undef VESTIGE_SANITIZED

/// What this process may not exceed, set before anything of the file is seen: address space, processor time,
/// no files written, no core dump; it ends with its parent. Under a sanitizer the address space stays free.
void limitProcess(std::uint64_t memoryBytes, std::uint64_t seconds);

/// From here on only what reads, computes and writes to descriptors that are open (seccomp, a list of the
/// calls that are allowed): every other call fails with EACCES, known or new. For after the libraries are
/// loaded.
void closeDoors();

}  // namespace vestige::importer
