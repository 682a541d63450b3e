#include "core/base/CancelScope.h"

#include "core/base/Result.h"

namespace vestige {
namespace {

thread_local const CancelScope* innermost = nullptr;

}  // namespace

CancelScope::CancelScope(const JobControl& control) : control_(control), outer_(innermost) {
    innermost = this;
}

CancelScope::~CancelScope() {
    innermost = outer_;
}

const JobControl* CancelScope::current() {
    return innermost ? &innermost->control_ : nullptr;
}

void throwIfCancelled() {
    const JobControl* job = CancelScope::current();
    if (job && job->cancelled()) throw ErrorException(cancelledError());
}

}  // namespace vestige
