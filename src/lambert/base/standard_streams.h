#pragma once
/// Standard input and output, which users name in place of a file: "-", or "png:-" where a format must be said.

#include <filesystem>
#include <string>

namespace lambert {

/// True of "-" and of "WORD:-", WORD of letters and digits. A file of such a name is "./-".
bool is_standard_stream(const std::filesystem::path& path);

/// What names the format of a file: ".png" of "a.PNG" and of "png:-", in lower case; empty where nothing does, as of
/// "-".
std::string format_extension(const std::filesystem::path& path);

/// How messages call a file that is read or written.
std::string input_name(const std::filesystem::path& path);
std::string output_name(const std::filesystem::path& path);

/// Keeps standard output for the one file that is written there: what else the process prints goes to standard error
/// from now on. Throws Error when it is kept already.
void reserve_standard_output();

/// The descriptor that takes the file.
int standard_output();

}  // namespace lambert
