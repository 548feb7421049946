#pragma once
#include <cstddef>
#include <map>
#include <string>

namespace lambert {

/// What a reader ignored or approximated, by name, each told once with a count. The caller prints them on standard
/// error; `lambert info` lists them.
class Notes {
 public:
  void add(const std::string& note) { ++counts_[note]; }
  const std::map<std::string, std::size_t>& counts() const { return counts_; }
  bool empty() const { return counts_.empty(); }

 private:
  std::map<std::string, std::size_t> counts_;
};

}  // namespace lambert
