#include "ui/document/CaseOpener.h"

#include "core/scene/CaseFile.h"

namespace vestige {

std::shared_ptr<CaseSession> CaseOpener::open(const std::filesystem::path& file) const {
    // The case that is open already is not taken from itself.
    if (!present_->place().empty() && present_->place() == casePlace(file) && present_->readOnly().empty())
        return present_;
    return std::make_shared<CaseSession>(autosaves_, file);
}

Result<std::shared_ptr<CaseSession>> CaseOpener::takeOver(const Abandoned& abandoned) const {
    auto session = std::make_shared<CaseSession>(autosaves_);
    if (const Status taken = session->takeOver(abandoned); !taken) return fail(taken.error());
    return session;
}

}  // namespace vestige
