#include "motion/live/bytes.h"

#include "motion/error.h"

namespace mien::motion {

void ByteWriter::text(const std::string& value) {
  whole(static_cast<int>(value.size()));
  bytes_ += value;
}

void ByteWriter::vector(const Vec3& value) {
  for (int i = 0; i < 3; ++i) number(value[i]);
}

void ByteWriter::rotation(const Quat& value) {
  for (int i = 0; i < 4; ++i) number(value.coeffs()[i]);
}

void ByteWriter::matrix(const Eigen::MatrixXd& value) {
  whole(static_cast<int>(value.rows()));
  whole(static_cast<int>(value.cols()));
  for (Eigen::Index i = 0; i < value.size(); ++i) number(value.data()[i]);
}

void ByteWriter::vector(const Eigen::VectorXd& value) {
  whole(static_cast<int>(value.size()));
  for (const double entry : value) number(entry);
}

void ByteWriter::numbers(const std::vector<double>& values) {
  whole(static_cast<int>(values.size()));
  for (const double value : values) number(value);
}

void ByteReader::refuse() {
  throw Error("the motions for the browser are damaged", "export or fetch them again");
}

void ByteReader::whole(int& value) { value = take<std::int32_t>(); }

void ByteReader::flag(bool& value) {
  const auto given = take<std::int32_t>();
  if (given != 0 && given != 1) refuse();
  value = given == 1;
}

void ByteReader::number(double& value) {
  value = take<double>();
  if (!std::isfinite(value)) refuse();
}

std::size_t ByteReader::count_of(std::size_t least_bytes) {
  int count = 0;
  whole(count);
  if (count < 0 || static_cast<std::size_t>(count) > remaining_.size() / least_bytes) refuse();
  return static_cast<std::size_t>(count);
}

void ByteReader::text(std::string& value) {
  const std::size_t length = count_of(1);
  value = remaining_.substr(0, length);
  remaining_.remove_prefix(length);
}

void ByteReader::vector(Vec3& value) {
  for (int i = 0; i < 3; ++i) number(value[i]);
}

void ByteReader::rotation(Quat& value) {
  for (int i = 0; i < 4; ++i) number(value.coeffs()[i]);
  if (std::abs(value.norm() - 1.0) > 1e-6) refuse();
}

void ByteReader::matrix(Eigen::MatrixXd& value) {
  int rows = 0, columns = 0;
  whole(rows);
  whole(columns);
  if (rows < 0 || columns < 0) refuse();
  const auto entries = static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(columns);
  if (entries > remaining_.size() / sizeof(double)) refuse();
  value.resize(rows, columns);
  for (Eigen::Index i = 0; i < value.size(); ++i) number(value.data()[i]);
}

void ByteReader::vector(Eigen::VectorXd& value) {
  value.resize(static_cast<Eigen::Index>(count_of(sizeof(double))));
  for (double& entry : value) number(entry);
}

void ByteReader::numbers(std::vector<double>& values) {
  values.resize(count_of(sizeof(double)));
  for (double& value : values) number(value);
}

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3u;
  }
  return hash;
}

}  // namespace mien::motion
