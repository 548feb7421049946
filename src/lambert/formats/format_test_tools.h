#pragma once
/// What tests of the readers share.

#include "lambert/base/error.h"
#include "lambert/formats/readers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lambert {

/// A folder that vanishes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "lambert-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, std::string_view content) const {
    std::ofstream(path_ / name, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// The message of the Error that `f` throws; fails the test when it throws none.
template <class F>
std::string error_of(F&& f) {
  try {
    f();
  } catch (const Error& e) {
    return e.what();
  }
  ADD_FAILURE() << "no Error was thrown";
  return {};
}

inline bool has_note(const Notes& notes, std::string_view part) {
  for (const auto& [note, count] : notes.counts()) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

/// The surfaces of all nodes in order, with their nodes.
struct Shown {
  NodeId node;
  Surface surface;
};
inline std::vector<Shown> shown(const SceneGraph& graph) {
  std::vector<Shown> all;
  for (NodeId n = 0; n < graph.node_count(); ++n) {
    for (const Surface& s : graph.surfaces(n)) all.push_back({n, s});
  }
  return all;
}
template <class T>
const T& geometry_as(const SceneGraph& graph, const Surface& s) {
  return std::get<T>(graph.geometry(s.geometry));
}
template <class T>
const T& shape_as(const SceneGraph& graph, const Surface& s) {
  return std::get<T>(geometry_as<Shape>(graph, s));
}
/// The material of the first surface.
inline const Material& first_material(const SceneGraph& graph) {
  return graph.materials[shown(graph).at(0).surface.material];
}

inline void expect_near(Vec3 a, Vec3 b, float tolerance = 1e-5f) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}
inline void expect_near(Rgb a, Rgb b, float tolerance = 1e-5f) {
  expect_near(Vec3(a.r, a.g, a.b), Vec3(b.r, b.g, b.b), tolerance);
}

/// Damages `text` in one of several ways: cut off, bytes changed, pieces doubled or removed, numbers replaced.
inline std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  static constexpr std::string_view nasty[] = {"-1", "1e999", "nan", "4294967295", "\"", "[",
                                               "]",  "\\",    "#",   "\n",         " "};
  for (std::size_t edits = 1 + below(3); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = below(text.size()), length = 1 + below(std::min<std::size_t>(text.size() - at, 40));
    switch (below(5)) {
      case 0: text.resize(at); break;
      case 1: text[at] = static_cast<char>(below(256)); break;
      case 2: text.insert(at, text.substr(at, length)); break;
      case 3: text.erase(at, length); break;
      default: text.replace(at, std::min<std::size_t>(length, 4), nasty[below(std::size(nasty))]);
    }
  }
  return text;
}

/// Reads `count` damaged versions of `text`: each is either read or refused with an Error.
template <class Read>
void expect_survives_damage(const std::string& text, int count, const Read& read) {
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    try {
      read(mutated(text, random));
    } catch (const Error& e) {
      ++refused;
      ASSERT_STRNE(e.what(), "");
    }
  }
  EXPECT_GT(refused, count / 10) << "the damage should show";
}

}  // namespace lambert
