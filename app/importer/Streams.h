#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace vestige::importer {

/// The whole of an open file in the address space, for as long as the process lives; throws ErrorException.
std::span<const std::byte> mapped(int descriptor);
/// Everything that a descriptor still has to say.
std::string readAll(int descriptor);
/// To standard output; ends the process when nobody listens any more.
void send(std::span<const std::byte> bytes);

}  // namespace vestige::importer
