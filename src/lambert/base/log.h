#pragma once
#include <string>
#include <string_view>

/// Words for people, on standard error; data never goes through here.
namespace lambert::log {

enum class Level { debug, info, warn, error, off };

void set_level(Level level);  ///< default: info
void debug(std::string_view message);
void info(std::string_view message);
void warn(std::string_view message);
void error(std::string_view message);

}  // namespace lambert::log
