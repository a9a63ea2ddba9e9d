#include "pipeline/tasks/disk_fault.h"

#include <cerrno>
#include <system_error>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

std::string fault_of(int code) {
  const test::TemporaryFolder temporary;
  const std::error_code told(code, std::generic_category());
  const std::string thrown = disk_fault(temporary.path(), std::system_error(told, "a.png"));
  EXPECT_EQ(disk_fault(temporary.path(), WriteFailure("a.png: cannot be written", told)), thrown);
  return thrown;
}

TEST(DiskFault, IsToldInPlainWordsWithoutTheFile) {
  EXPECT_NE(fault_of(ENOSPC).find(" is full; free some space"), std::string::npos);
  EXPECT_NE(fault_of(EDQUOT).find("your quota"), std::string::npos);
  EXPECT_NE(fault_of(EROFS).find("Read-only file system"), std::string::npos);
  EXPECT_EQ(fault_of(ENOSPC).find("a.png"), std::string::npos);
}

TEST(DiskFault, IsToldOfAFolderThatIsAwayButNotInPlaceOfAnotherReason) {
  const test::TemporaryFolder temporary;
  const auto away = temporary.path() / "away";
  const std::string told = disk_fault(away, std::runtime_error("no picture"));
  EXPECT_NE(told.find("away is not there (No such file or directory); restore the disk"),
            std::string::npos)
      << told;
  const std::error_code denied(EACCES, std::generic_category());
  EXPECT_EQ(disk_fault(away, std::system_error(denied, "a.png")), "");
  EXPECT_EQ(current_disk_problem(away), "");
}

TEST(DiskFault, IsTheSameHoweverOftenItIsAsked) {
  const test::TemporaryFolder temporary;
  const std::error_code full(ENOSPC, std::generic_category());
  const std::string told = disk_fault(temporary.path(), WriteFailure("a: no", full));
  EXPECT_EQ(disk_fault(temporary.path(), DiskFault(told)), told) << "there is room by now";
}

TEST(DiskFault, IsNoneWhereTheDiskIsWell) {
  EXPECT_EQ(fault_of(EACCES), "");
  EXPECT_EQ(fault_of(EIO), "");
  const test::TemporaryFolder temporary;
  EXPECT_EQ(disk_fault(temporary.path(), std::runtime_error("no picture")), "");
}

}  // namespace
}  // namespace mien::pipeline
