#pragma once
/// Settings of methods and operators by name, as `--set key=value` and the browser view give them.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace lambert {

/// One named setting bound to a member of a settings struct that outlives it.
struct Setting {
  std::string key;
  std::string help;
  std::variant<int*, float*, bool*, std::string*> target;
  std::vector<std::string> choices = {};  ///< allowed words; empty: any
  std::optional<int> least = {};          ///< of a number
  std::optional<float> above = {};        ///< a number must be greater
  std::optional<float> most = {};         ///< of a number
};

/// The settings of one method or operator.
class SettingTable {
 public:
  explicit SettingTable(std::vector<Setting> settings) : settings_(std::move(settings)) {}
  /// Throws Error naming the key, the value and what was expected.
  void set(std::string_view key, std::string_view value);
  const std::vector<Setting>& settings() const { return settings_; }

 private:
  std::vector<Setting> settings_;
};

/// The present value as text.
std::string to_string(const Setting& s);

}  // namespace lambert
