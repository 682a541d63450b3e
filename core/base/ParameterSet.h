#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/ParameterSpec.h"
#include "core/base/Result.h"

namespace vestige {

/// Values for the parameters of one table: the defaults, and what was set to differ. The table must outlive
/// the set; tables are static.
class ParameterSet {
  public:
    explicit ParameterSet(const ParameterTable& table);

    const ParameterTable& table() const { return *table_; }
    const ParameterSpec* find(std::string_view key) const;

    /// Checks name, type, range and choices; ErrorCode::usage that names the parameter and what is allowed.
    Status set(std::string_view key, ParameterValue value);
    /// For a value the program derived: the allowed one of a real parameter that is nearest to it.
    void setNearest(std::string_view key, double value);
    /// The same from text, as written on a command line or in a form ("auto" for automatic).
    Status setFromText(std::string_view key, std::string_view text);

    bool isDefault(std::string_view key) const;
    const ParameterValue& value(std::string_view key) const;

    bool boolean(std::string_view key) const;
    std::int64_t integer(std::string_view key) const;
    double real(std::string_view key) const;
    /// Nothing when the parameter is automatic.
    std::optional<double> optionalReal(std::string_view key) const;
    const std::string& text(std::string_view key) const;

    /// The value as a person reads it, with unit: "0.2 m", "automatic".
    std::string display(std::string_view key) const;

    friend bool operator==(const ParameterSet& a, const ParameterSet& b) {
        return a.table_ == b.table_ && a.values_ == b.values_;
    }

  private:
    const ParameterTable* table_;
    std::map<std::string, ParameterValue, std::less<>> values_;
};

}  // namespace vestige
