#pragma once
/// OpenEXR's streams on bytes in memory.

#include "lambert/image/formats/codecs.h"

#include <ImfIO.h>

#include <cstring>
#include <string>
#include <vector>

namespace lambert {

class MemoryInput final : public Imf::IStream {
 public:
  MemoryInput(Bytes data, const std::string& name) : IStream(name.c_str()), data_(data) {}
  bool read(char c[], int n) override {
    const auto count = static_cast<std::size_t>(n > 0 ? n : 0);
    if (count > data_.size() - at_) decode_error(fileName(), "ends at byte " + std::to_string(data_.size()));
    std::memcpy(c, data_.data() + at_, count);
    at_ += count;
    return at_ < data_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override {
    if (position > data_.size()) decode_error(fileName(), "points behind its end");
    at_ = static_cast<std::size_t>(position);
  }

 private:
  Bytes data_;
  std::size_t at_ = 0;
};

class MemoryOutput final : public Imf::OStream {
 public:
  MemoryOutput() : OStream("memory") {}
  void write(const char c[], int n) override {
    const auto count = static_cast<std::size_t>(n);
    if (bytes.size() < at_ + count) bytes.resize(at_ + count);
    std::memcpy(bytes.data() + at_, c, count);
    at_ += count;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }
  std::vector<std::byte> bytes;

 private:
  std::size_t at_ = 0;
};

}  // namespace lambert
