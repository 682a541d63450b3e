#pragma once

#include <exception>
#include <new>
#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "core/base/Error.h"

namespace vestige {

/// A value or the Error that explains why there is none. Every public function that can fail returns one.
template <class T>
using Result = tl::expected<T, Error>;
using Status = Result<void>;

/// `return fail(...)` from any function that returns a Result.
inline tl::unexpected<Error> fail(Error error) {
    return tl::unexpected<Error>(std::move(error));
}
inline tl::unexpected<Error> fail(ErrorCode code, std::string message, std::string place = {},
                                  std::string hint = {}) {
    return fail(Error{code, std::move(message), std::move(place), std::move(hint)});
}

/// Inside one .cpp file or a parallel loop an Error may travel as this exception; `guarded` turns it (and
/// std::bad_alloc, std::exception) back into a Result where the function or job ends.
struct ErrorException : std::exception {
    explicit ErrorException(Error what) : error(std::move(what)) {}
    const char* what() const noexcept override { return error.message.c_str(); }
    Error error;
};

/// Runs `work`, which returns Result<T>; exceptions become an Error that carries `place`.
template <class Work>
auto guarded(const std::string& place, Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const ErrorException& thrown) {
        return fail(thrown.error);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::input, "there is not enough memory for this step", place);
    } catch (const std::exception& thrown) {
        return fail(ErrorCode::input, thrown.what(), place);
    }
}

}  // namespace vestige
