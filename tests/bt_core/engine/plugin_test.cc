// The plugins are those of the folder plugins/; this program is linked with coppice_load_plugins.
#include "bt_core/engine/plugin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"
#include "tests/support/folders.h"

namespace coppice {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

std::string PathOf(const std::string& plugin) {
  return BinaryFolder() + "/tests/bt_core/plugin_" + plugin + ".so";
}

std::string ErrorOf(Registry& registry, const std::string& path) {
  try {
    registry.LoadPlugin(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Plugin, AddsItsNodeTypes) {
  auto registry = std::make_shared<Registry>();
  registry->LoadPlugin(PathOf("good"));
  LeafHarness half(registry, "Half");
  half.Set("number", 5.0);
  EXPECT_EQ(half.Tick(), Status::kSuccess);
  EXPECT_EQ(half.Get<double>("half"), 2.5);
  LeafHarness small(registry, "IsSmall");
  small.Set("number", 0.5);
  EXPECT_EQ(small.Tick(), Status::kSuccess);
}

TEST(Plugin, ItsExceptionsAreThoseOfTheEngine) {
  auto registry = std::make_shared<Registry>();
  registry->LoadPlugin(PathOf("good"));
  LeafHarness half(registry, "Half");
  EXPECT_EQ(half.Tick(), Status::kFailure);
  EXPECT_THAT(half.message(), HasSubstr(R"("number")"));
}

TEST(Plugin, OutlivesTheRegistry) {
  Value value;
  {
    Registry registry;
    registry.LoadPlugin(PathOf("good"));
    value.Parse(*registry.Find("Half")->manifest.ports[0].type, "1.5");
  }
  EXPECT_EQ(value.Print(), "1.5");
}

TEST(Plugin, AMissingFileIsNamed) {
  Registry registry;
  EXPECT_THAT(ErrorOf(registry, "nowhere.so"),
              AllOf(StartsWith("nowhere.so: "), EndsWith("No such file or directory")));
}

TEST(Plugin, AFileThatIsNoLibraryIsRefused) {
  Registry registry;
  EXPECT_THAT(ErrorOf(registry, SourceFolder() + "/README.md"),
              HasSubstr("README.md: invalid ELF header"));
}

TEST(Plugin, ALibraryOfSomethingElseIsRefused) {
  Registry registry;
  EXPECT_THAT(ErrorOf(registry, PathOf("no_plugin")), EndsWith("it has no COPPICE_PLUGIN"));
}

TEST(Plugin, AnotherVersionIsRefused) {
  Registry registry;
  EXPECT_THAT(ErrorOf(registry, PathOf("old_version")),
              EndsWith(std::string("was built for Coppice 0.0.9, this is Coppice ") + kVersion));
}

TEST(Plugin, OtherHeadersAreRefused) {
  Registry registry;
  EXPECT_THAT(ErrorOf(registry, PathOf("other_headers")), HasSubstr("other headers"));
}

TEST(Plugin, AnEngineOfItsOwnIsRefused) {
  Registry registry;
  EXPECT_THAT(ErrorOf(registry, PathOf("own_types")), HasSubstr("brings an engine of its own"));
}

TEST(Plugin, IsNotLoadedByHalves) {
  Registry registry;
  EXPECT_THAT(ErrorOf(registry, PathOf("taken_id")),
              EndsWith(R"(node ID "Sequence" is already registered)"));
  EXPECT_EQ(registry.Find("New"), nullptr);
}

TEST(Plugin, TwiceIsAnError) {
  Registry registry;
  registry.LoadPlugin(PathOf("good"));
  EXPECT_THAT(ErrorOf(registry, PathOf("good")), HasSubstr("already registered"));
}

}  // namespace
}  // namespace coppice
