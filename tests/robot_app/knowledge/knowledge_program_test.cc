// coppice-knowledge as its user calls it.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::knowledge {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Called {
  int status = -1;
  std::string output;
};

class KnowledgeProgram : public testing::Test {
 protected:
  Called Call(const std::string& arguments) const {
    const std::string command = BinaryFolder() + "/bin/coppice-knowledge " + arguments + " 2>&1";
    Called called;
    FILE* const pipe = popen(command.c_str(), "r");
    char buffer[256];
    while (std::fgets(buffer, sizeof(buffer), pipe)) called.output += buffer;
    const int status = pclose(pipe);
    if (WIFEXITED(status)) called.status = WEXITSTATUS(status);
    return called;
  }
  Called Import() const {
    return Call("import " + SourceFolder() + "/robot_app/knowledge/sample " + database_);
  }

  TemporaryFolder folder_;
  const std::string database_ = folder_.Path("campus.db");
};

TEST_F(KnowledgeProgram, TheSampleIsImportedAndAsked) {
  const Called imported = Import();
  EXPECT_EQ(imported.status, 0) << imported.output;
  EXPECT_THAT(imported.output, HasSubstr("41 places, 15 people"));
  EXPECT_EQ(Call("ask " + database_ + " 'office of Weber' Anna --at '2026-11-25 12:00'").output,
            "Did you mean Prof. Dr. Anna Weber or Dr. Paul Weber?\n"
            "Prof. Dr. Anna Weber is in office 101, on the ground floor of the institute building. "
            "I can take you there.\n");
  EXPECT_THAT(Call("show " + database_).output, StartsWith("time zone Europe/Berlin\nperson 15\n"));
  EXPECT_THAT(Call("show " + database_ + " line").output, HasSubstr("S3  en:S3  de:S3"));
}

TEST_F(KnowledgeProgram, TheOperatorSeesWhatIsUnknownAndNamesIt) {
  Import();
  Call("ask " + database_ + " 'where is the pool' --at '2026-11-25 12:00'");
  EXPECT_EQ(Call("unknown " + database_).output, "1  2026-11-25  en  where is the pool\n");
  EXPECT_EQ(Call("synonym " + database_ + " place gym pool").status, 0);
  EXPECT_EQ(Call("synonym " + database_).output, "place  gym  en  pool\n");
  EXPECT_THAT(Call("ask " + database_ + " 'where is the pool'").output,
              StartsWith("The sports hall"));
  EXPECT_EQ(Call("synonym " + database_ + " place gym pool --remove").status, 0);
  EXPECT_EQ(Call("unknown " + database_ + " --clear").status, 0);
  EXPECT_EQ(Call("unknown " + database_).output, "");
}

TEST_F(KnowledgeProgram, AFolderWithMistakesLeavesTheOldKnowledge) {
  Import();
  std::filesystem::copy(SourceFolder() + "/robot_app/knowledge/sample", folder_.Path("broken"),
                        std::filesystem::copy_options::recursive);
  coppice::WriteFile(folder_.Path("broken/staff.csv"), "given_name,family_name\nAda\n");
  const Called broken = Call("import " + folder_.Path("broken") + " " + database_);
  EXPECT_EQ(broken.status, 1);
  EXPECT_THAT(broken.output, HasSubstr("staff.csv:2: error: expected 2 fields, not 1"));
  EXPECT_THAT(Call("show " + database_).output, HasSubstr("person 15"));
}

TEST_F(KnowledgeProgram, WrongArgumentsAreSaid) {
  EXPECT_EQ(Call("--help").status, 0);
  EXPECT_EQ(Call("").status, 2);
  EXPECT_THAT(Call("shwo").output, HasSubstr("unknown verb \"shwo\" (did you mean \"show\"?)"));
  EXPECT_EQ(Call("show").status, 2);
  EXPECT_EQ(Call("show " + database_).status, 1);
  Import();
  EXPECT_EQ(Call("ask " + database_ + " help --at noon").status, 2);
  EXPECT_EQ(Call("synonym " + database_ + " place gym").status, 2);
  EXPECT_EQ(Call("synonym " + database_ + " plaice gym x").status, 2);
}

}  // namespace
}  // namespace coppice::robot::knowledge
