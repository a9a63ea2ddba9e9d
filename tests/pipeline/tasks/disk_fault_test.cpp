#include "pipeline/tasks/disk_fault.h"

#include <cerrno>
#include <system_error>

#include <gtest/gtest.h>

#include "pipeline/documents/files.h"
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
  EXPECT_NE(fault_of(ENOSPC).find(" is full; make room"), std::string::npos);
  EXPECT_NE(fault_of(EDQUOT).find("your quota"), std::string::npos);
  EXPECT_NE(fault_of(EROFS).find("Read-only file system"), std::string::npos);
  EXPECT_EQ(fault_of(ENOSPC).find("a.png"), std::string::npos);
}

TEST(DiskFault, IsNoneWhereTheDiskIsWell) {
  EXPECT_EQ(fault_of(EACCES), "");
  EXPECT_EQ(fault_of(EIO), "");
  const test::TemporaryFolder temporary;
  EXPECT_EQ(disk_fault(temporary.path(), std::runtime_error("no picture")), "");
}

}  // namespace
}  // namespace mien::pipeline
