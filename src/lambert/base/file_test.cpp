#include "lambert/base/file.h"

#include "lambert/base/error.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>
#include <stdexcept>

namespace lambert {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("lambert_files_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Files() override { fs::remove_all(folder_); }
  fs::path path(const char* name) const { return folder_ / name; }
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

 private:
  fs::path folder_;
};

TEST_F(Files, WrittenTextIsReadBack) {
  write_atomically(path("a.txt"), "one\ntwo");
  EXPECT_EQ(MappedFile(path("a.txt")).text(), "one\ntwo");
  write_atomically(path("a.txt"), "three");
  EXPECT_EQ(MappedFile(path("a.txt")).text(), "three");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Files, WriterSeesAFileBeside) {
  write_atomically(path("a.exr"), [&](const fs::path& temporary) {
    EXPECT_NE(temporary, path("a.exr"));
    EXPECT_EQ(temporary.parent_path(), path("a.exr").parent_path());
    std::ofstream(temporary) << "pixels";
    EXPECT_FALSE(fs::exists(path("a.exr")));
  });
  EXPECT_EQ(MappedFile(path("a.exr")).text(), "pixels");
}

TEST_F(Files, ExceptionLeavesTheOldFileAndNothingElse) {
  write_atomically(path("a.txt"), "old");
  const auto fail = [](const fs::path& temporary) {
    std::ofstream(temporary) << "half";
    throw std::runtime_error("stop");
  };
  EXPECT_THROW(write_atomically(path("a.txt"), fail), std::runtime_error);
  EXPECT_THROW(write_atomically(path("b.txt"), fail), std::runtime_error);
  EXPECT_EQ(MappedFile(path("a.txt")).text(), "old");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Files, ErrorsNameTheFile) {
  const auto message = [](const auto& act) -> std::string {
    try {
      act();
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  };
  const fs::path deep = path("none") / "a.txt";
  EXPECT_NE(message([&] { write_atomically(deep, "x"); }).find(deep.string()), std::string::npos);
  EXPECT_NE(message([&] { MappedFile f(deep); }).find(deep.string()), std::string::npos);
  EXPECT_NE(message([&] { MappedFile f(path(".")); }).find("not a regular file"), std::string::npos);
}

TEST_F(Files, NamesMayBeAsLongAsTheFileSystemAllows) {
  const std::string name = std::string(251, 'n') + ".png";
  check_writable(path(name.c_str()));
  write_atomically(path(name.c_str()), "x");
  EXPECT_EQ(MappedFile(path(name.c_str())).text(), "x");
  EXPECT_THROW(check_writable(path(("n" + name).c_str())), Error);
  EXPECT_THROW(write_atomically(path(("n" + name).c_str()), "x"), Error);
}

TEST_F(Files, LinksStayAndTheirTargetsAreWritten) {
  fs::create_directory(path("there"));
  fs::create_symlink("there/a.txt", path("one"));
  fs::create_symlink(path("one"), path("two"));
  for (const char* text : {"first", "second"}) {
    check_writable(path("two"));
    write_atomically(path("two"), text);
    EXPECT_TRUE(fs::is_symlink(path("one")) && fs::is_symlink(path("two")));
    EXPECT_FALSE(fs::is_symlink(path("there/a.txt")));
    EXPECT_EQ(MappedFile(path("there/a.txt")).text(), text);
  }
  fs::create_symlink("round", path("round"));
  EXPECT_THROW(write_atomically(path("round"), "x"), Error);
}

TEST_F(Files, CheckWritableLeavesNothing) {
  write_atomically(path("old"), "old");
  check_writable(path("old"));
  check_writable(path("new"));
  EXPECT_EQ(MappedFile(path("old")).text(), "old");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Files, WhatIsNoRegularFileIsNotReplaced) {
  const fs::path folder = path("folder"), pipe = path("pipe");
  fs::create_directory(folder);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const fs::path& p : {folder, pipe, path("missing") / "a", path("pipe") / "a", fs::path("/dev/null")}) {
    EXPECT_THROW(check_writable(p), Error) << p;
    EXPECT_THROW(write_atomically(p, "x"), Error) << p;
  }
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_THROW(check_writable("/proc/a.txt"), Error) << "a folder that takes no files, even root's";
}

TEST_F(Files, EmptyFileHasNoBytes) {
  write_atomically(path("empty"), "");
  EXPECT_TRUE(MappedFile(path("empty")).bytes().empty());
}

TEST_F(Files, MovedMappingStaysReadable) {
  write_atomically(path("a"), "abc");
  MappedFile first(path("a"));
  const MappedFile second(std::move(first));
  EXPECT_EQ(second.text(), "abc");
}

}  // namespace
}  // namespace lambert
