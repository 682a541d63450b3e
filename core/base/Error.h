#pragma once

#include <string>

namespace vestige {

/// Why something did not work; the values are the exit codes of `vestige-cli`.
enum class ErrorCode {
    usage = 2,          ///< the request itself is wrong (unknown option, value out of range)
    input = 3,          ///< an input is missing, unreadable or malformed
    untrustworthy = 4,  ///< a computation ended without a result that can be relied on
    output = 5,         ///< an output could not be written
    cancelled = 130     ///< the user or a signal asked to stop; never shown as a failure
};

/// One failure, told to a person: what is wrong, where, and what was expected or can be done.
struct Error {
    ErrorCode code = ErrorCode::input;
    std::string
        message;  ///< one sentence without final full stop, e.g. "the header ends after 12 of 227 bytes"
    std::string place;  ///< file with line or byte, parameter, stage; may be empty
    std::string hint;   ///< what was expected or helps; may be empty
    /// Of a damaged input: part of it is whole and can be read where the user agrees.
    bool salvageable = false;

    /// "place: message; hint" with the empty parts left out.
    std::string sentence() const;
};

/// The error of a job that was cancelled.
Error cancelledError();

}  // namespace vestige
