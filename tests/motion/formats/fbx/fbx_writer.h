#pragma once

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <zlib.h>

namespace mien::test {

/// Bytes that are no text, such as those of a picture.
struct FbxTestBytes {
  std::string bytes;
};

/// A node of an FBX file as tests build it. Texts hold "Name::Class" as in binary files: "\0\1".
struct FbxTestNode {
  using Value = std::variant<std::int32_t, std::int64_t, double, std::string, std::vector<double>,
                             std::vector<float>, std::vector<std::int32_t>,
                             std::vector<std::int64_t>, FbxTestBytes>;
  std::string name;
  std::vector<Value> values;
  std::vector<FbxTestNode> children;
};

/// A writer of its own, which shares nothing with the reader.
class FbxTestWriter {
 public:
  FbxTestWriter(int version, bool deflates) : version_(version), deflates_(deflates) {}

  std::string file(const std::vector<FbxTestNode>& nodes) {
    bytes_ = std::string("Kaydara FBX Binary  \0\x1a\0", 23);
    number<std::uint32_t>(static_cast<std::uint32_t>(version_));
    for (const FbxTestNode& node : nodes) write(node);
    bytes_.append(record_size(), '\0');
    bytes_ += "footer";
    return bytes_;
  }

 private:
  size_t record_size() const { return version_ >= 7500 ? 25 : 13; }

  template <class Number>
  void number(Number value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes_.append(raw, sizeof value);
  }

  void put_offset(size_t at, std::uint64_t value) {
    std::memcpy(bytes_.data() + at, &value, version_ >= 7500 ? 8 : 4);
  }

  template <class Number>
  void array(char type, const std::vector<Number>& numbers) {
    bytes_ += type;
    number<std::uint32_t>(static_cast<std::uint32_t>(numbers.size()));
    const size_t size = numbers.size() * sizeof(Number);
    std::string plain(size, '\0');
    if (size > 0) std::memcpy(plain.data(), numbers.data(), size);
    if (deflates_) {
      uLongf packed_size = compressBound(size);
      std::string packed(packed_size, '\0');
      compress(reinterpret_cast<Bytef*>(packed.data()), &packed_size,
               reinterpret_cast<const Bytef*>(plain.data()), size);
      plain = packed.substr(0, packed_size);
    }
    number<std::uint32_t>(deflates_ ? 1 : 0);
    number<std::uint32_t>(static_cast<std::uint32_t>(plain.size()));
    bytes_ += plain;
  }

  void operator()(std::int32_t value) { bytes_ += 'I', number(value); }
  void operator()(std::int64_t value) { bytes_ += 'L', number(value); }
  void operator()(double value) { bytes_ += 'D', number(value); }
  void operator()(const std::string& text) {
    bytes_ += 'S';
    number<std::uint32_t>(static_cast<std::uint32_t>(text.size()));
    bytes_ += text;
  }
  void operator()(const FbxTestBytes& raw) {
    bytes_ += 'R';
    number<std::uint32_t>(static_cast<std::uint32_t>(raw.bytes.size()));
    bytes_ += raw.bytes;
  }
  void operator()(const std::vector<double>& numbers) { array('d', numbers); }
  void operator()(const std::vector<float>& numbers) { array('f', numbers); }
  void operator()(const std::vector<std::int32_t>& numbers) { array('i', numbers); }
  void operator()(const std::vector<std::int64_t>& numbers) { array('l', numbers); }

  void write(const FbxTestNode& node) {
    const size_t start = bytes_.size();
    const size_t width = version_ >= 7500 ? 8 : 4;
    bytes_.append(3 * width, '\0');
    bytes_ += static_cast<char>(node.name.size());
    bytes_ += node.name;
    const size_t list = bytes_.size();
    for (const FbxTestNode::Value& value : node.values) {
      std::visit([this](const auto& one) { (*this)(one); }, value);
    }
    const size_t list_size = bytes_.size() - list;
    for (const FbxTestNode& child : node.children) write(child);
    if (!node.children.empty()) bytes_.append(record_size(), '\0');
    put_offset(start, bytes_.size());
    put_offset(start + width, node.values.size());
    put_offset(start + 2 * width, list_size);
  }

  int version_;
  bool deflates_;
  std::string bytes_;
};

/// The same as text. "Name\0\1Class" is written as "Class::Name".
class FbxTestTextWriter {
 public:
  std::string file(const std::vector<FbxTestNode>& nodes) {
    text_ << "; FBX 7.4.0 project file\n; made by a test\n\n";
    text_.precision(17);
    for (const FbxTestNode& node : nodes) write(node, 0);
    return text_.str();
  }

 private:
  static std::string quoted(const std::string& text) {
    std::string name = text;
    if (const size_t at = text.find(std::string("\0\1", 2)); at != std::string::npos) {
      name = text.substr(at + 2) + "::" + text.substr(0, at);
    }
    for (size_t at = name.find('"'); at != std::string::npos; at = name.find('"', at)) {
      name.replace(at, 1, "&quot;");
    }
    return '"' + name + '"';
  }

  static std::string base64(const std::string& bytes) {
    constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
      std::uint32_t three = 0;
      for (size_t k = 0; k < 3; ++k) {
        const auto byte = i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u;
        three = three << 8 | byte;
      }
      for (int k = 3; k >= 0; --k) text += letters[three >> (6 * k) & 63];
    }
    for (size_t k = 0; k < (3 - bytes.size() % 3) % 3; ++k) text[text.size() - 1 - k] = '=';
    return text;
  }

  template <class Number>
  void array(const std::vector<Number>& numbers) {
    text_ << '*' << numbers.size() << " {\n a: ";
    for (size_t i = 0; i < numbers.size(); ++i) {
      // Long lists are broken after commas.
      text_ << (i > 0 ? "," : "") << (i % 5 == 4 ? "\n" : "") << numbers[i];
    }
    text_ << "\n}";
  }

  void operator()(const std::string& text) { text_ << quoted(text); }
  /// In base64, in pieces on lines of their own, as programs write it after an empty value.
  void operator()(const FbxTestBytes& raw) {
    constexpr size_t piece = 57;
    for (size_t at = 0; at < raw.bytes.size(); at += piece) {
      text_ << (at > 0 ? ",\n" : ",") << '"' << base64(raw.bytes.substr(at, piece)) << '"';
    }
  }
  template <class Number>
  void operator()(const std::vector<Number>& numbers) {
    array(numbers);
  }
  template <class Number>
  void operator()(Number number) {
    text_ << number;
  }

  void write(const FbxTestNode& node, int depth) {
    text_ << std::string(static_cast<size_t>(depth), '\t') << node.name << ": ";
    for (size_t v = 0; v < node.values.size(); ++v) {
      if (v > 0) text_ << ", ";
      std::visit([this](const auto& one) { (*this)(one); }, node.values[v]);
    }
    if (!node.children.empty()) {
      text_ << " {\n";
      for (const FbxTestNode& child : node.children) write(child, depth + 1);
      text_ << std::string(static_cast<size_t>(depth), '\t') << "}";
    }
    text_ << "\n";
  }

  std::ostringstream text_;
};

}  // namespace mien::test
