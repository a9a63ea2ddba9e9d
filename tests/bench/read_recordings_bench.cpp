// Megabytes of recordings read per second, from the path of a file to the motion or the points in
// memory, of files of 20 MB and more that are made first: in a folder that is named, where they are
// kept and used again, or else in a temporary one. Other recordings may be named as well:
// read_recordings_bench --benchmark_filter=c3d /tmp/long walk.c3d
//
// MB/s are those of the file as it is on the disk. For files with compressed contents, "unpacked"
// gives those of the numbers that come out, where that size is known.

#include <filesystem>
#include <fstream>
#include <string>

#include <benchmark/benchmark.h>

#include "motion/formats/motion_file.h"
#include "motion/formats/numpy/npz.h"
#include "pipeline/temporary_folder.h"

#include "long_recordings.h"

namespace {

using namespace mien::motion;

/// Bytes of the arrays in an .npz file; 0 for other files.
double unpacked_bytes(const std::filesystem::path& file) {
  if (lower_case_ending(file) != ".npz") return 0.0;
  double bytes = 0.0;
  for (const NpyArray& array : read_npz(file).arrays)
    bytes += static_cast<double>(array.bytes.size());
  return bytes;
}

void count_bytes(benchmark::State& state, double file_bytes, double unpacked) {
  const auto rate = [](double bytes) {
    return benchmark::Counter(bytes / 1e6, benchmark::Counter::kIsIterationInvariantRate);
  };
  state.counters["MB"] = file_bytes / 1e6;
  state.counters["MB/s"] = rate(file_bytes);
  if (unpacked > 0.0) state.counters["unpacked MB/s"] = rate(unpacked);
}

/// A file, and how it is made if it is not there.
struct Measured {
  std::filesystem::path file;
  std::string (*bytes)() = nullptr;
  double unpacked = 0.0;  ///< 0: as in the file
};

void make(const Measured& measured) {
  if (measured.bytes == nullptr || std::filesystem::exists(measured.file)) return;
  std::ofstream(measured.file, std::ios::binary) << measured.bytes();
}

double unpacked_bytes(const Measured& measured) {
  return measured.unpacked > 0.0 ? measured.unpacked : unpacked_bytes(measured.file);
}

void read_whole(benchmark::State& state, const Measured& measured) {
  make(measured);
  for (auto _ : state) benchmark::DoNotOptimize(read_file(measured.file));
  count_bytes(state, static_cast<double>(std::filesystem::file_size(measured.file)),
              unpacked_bytes(measured));
}

/// As numpy.load does.
void read_arrays(benchmark::State& state, const Measured& measured) {
  make(measured);
  for (auto _ : state) benchmark::DoNotOptimize(read_npz(measured.file));
  count_bytes(state, static_cast<double>(std::filesystem::file_size(measured.file)),
              unpacked_bytes(measured));
}

void measure(const std::string& title, const Measured& measured) {
  const auto add = [&](const std::string& name, auto read) {
    benchmark::RegisterBenchmark(name.c_str(), read, measured)->Unit(benchmark::kMillisecond);
  };
  add(title, read_whole);
  if (lower_case_ending(measured.file) == ".npz") add(title + ", arrays alone", read_arrays);
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  const mien::test::TemporaryFolder temporary;
  std::filesystem::path folder = temporary.path();
  for (int i = 1; i < count; ++i)
    if (std::filesystem::is_directory(arguments[i])) folder = arguments[i];
  for (const mien::bench::LongFile& made : mien::bench::long_files)
    measure(std::string(made.title), {folder / made.name, made.bytes, made.unpacked});
  for (int i = 1; i < count; ++i)
    if (!std::filesystem::is_directory(arguments[i])) measure(arguments[i], {arguments[i]});
  benchmark::RunSpecifiedBenchmarks();
}
