#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/scene/store/CaseStore.h"

namespace vestige {

/// What a window that ended before its time left behind.
struct Abandoned {
    std::filesystem::path folder;
    StoredCase content;
};

/// The folder, in the user's own data, for edits that cannot be kept with their case: of a case that was
/// never saved, is a single JSON file, or lies where nothing can be written. Each is a store of its own.
class Autosaves {
  public:
    explicit Autosaves(std::filesystem::path root) : root_(std::move(root)) {}

    /// A new one for the case at `place` (casePlace; empty: none yet).
    Result<std::unique_ptr<CaseStore>> create(const std::filesystem::path& place) const;
    /// Those that no living window has open; such without edits are removed.
    std::vector<Abandoned> abandoned() const;
    /// The newest of them that belongs to the case at `place`.
    std::optional<Abandoned> abandonedOf(const std::filesystem::path& place) const;
    /// Deletes one.
    static void remove(const std::filesystem::path& folder);

  private:
    std::filesystem::path root_;
};

}  // namespace vestige
