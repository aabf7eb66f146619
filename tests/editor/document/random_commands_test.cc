// What must hold for every sequence of commands on every file: undo restores each byte, redo too,
// and what is saved is read as the same tree. COPPICE_TREES names a folder with further files.
#include <algorithm>
#include <cstdlib>
#include <random>

#include "editor/document/drop_edits.h"
#include "editor/document/fragment.h"
#include "editor/document/project_names.h"
#include "editor/document/subtree_edits.h"
#include "editor/document/tree_edits.h"
#include "editor/files/open_project.h"
#include "tests/editor/document/drafts.h"
#include "tests/editor/driver.h"
#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = "random.xml";

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  std::size_t Below(std::size_t limit) { return random_() % limit; }
  bool OneIn(unsigned count) { return Below(count) == 0; }
  std::string Pick(const std::vector<std::string>& choices) {
    return choices[Below(choices.size())];
  }

 private:
  std::mt19937 random_;
};

std::string RandomTree(Dice& dice, int depth, const std::string& indentation) {
  const std::string tag = depth == 0 ? dice.Pick({"A", "B", "Wait"})
                                     : dice.Pick({"Sequence", "Fallback", "Inverter", "X"});
  std::string text = indentation + "<" + tag;
  if (dice.OneIn(2)) text += dice.Pick({" name='n'", R"( goal="{goal}")", "\n   msec = \"5\""});
  if (dice.OneIn(6)) text += dice.Pick({R"( _skipIf="a &lt; 3")", " _skipIf='true'"});
  const std::size_t children = tag == "Inverter" ? 1 : dice.Below(4);
  if (depth == 0 || children == 0) return text + dice.Pick({"/>", " />"});
  text += ">";
  const std::string line = dice.OneIn(6) ? "" : "\n" + indentation + "  ";
  for (std::size_t i = 0; i < children; ++i) {
    if (dice.OneIn(5)) text += line + dice.Pick({"<!-- c -->", "<!-- <A/> -->", "words"});
    if (line.empty()) {
      text += RandomTree(dice, depth - 1, "");
    } else {
      text += "\n" + RandomTree(dice, depth - 1, indentation + "  ");
    }
  }
  return text + (line.empty() ? "" : "\n" + indentation) + "</" + tag + ">";
}

std::string RandomFile(Dice& dice) {
  std::string text = "<root BTCPP_format=\"4\">\n  <BehaviorTree ID=\"Main\">\n" +
                     RandomTree(dice, static_cast<int>(dice.Below(5)), "    ") +
                     "\n  </BehaviorTree>\n</root>" + dice.Pick({"", "\n", "\n\n"});
  if (!dice.OneIn(4)) return text;
  std::string with_returns;
  for (const char c : text) with_returns += c == '\n' ? "\r\n" : std::string(1, c);
  return with_returns;
}

class Session {
 public:
  Session(std::string text, const NodeRules& rules, Dice& dice)
      : original_(std::move(text)), rules_(rules), dice_(dice) {
    project_.Create(kFile, original_);
  }

  bool is_readable() const { return file().document.has_value(); }

  void Run(int commands) {
    std::vector<std::string> texts = {original_};
    for (int i = 0; i < commands; ++i) {
      const std::size_t steps = project_.history().done();
      RunOne();
      CheckText();
      if (testing::Test::HasFailure()) return;
      if (project_.history().done() > steps) texts.push_back(file().text);
      if (dice_.OneIn(10)) WalkHistory(texts);
    }
    while (project_.history().undo()) {
      project_.Undo();
      texts.pop_back();
      ASSERT_EQ(file().text, texts.back());
    }
    ASSERT_EQ(file().text, original_);
  }

 private:
  const EditedFile& file() const { return *project_.Find(kFile); }

  // Some steps back and forth; in the end all are done again.
  void WalkHistory(const std::vector<std::string>& texts) {
    for (std::size_t back = dice_.Below(8); back > 0 && project_.history().undo(); --back) {
      project_.Undo();
      ASSERT_EQ(file().text, texts[project_.history().done()]);
    }
    while (project_.history().redo()) {
      project_.Redo();
      ASSERT_EQ(file().text, texts[project_.history().done()]);
    }
  }

  void CheckText() {
    ASSERT_TRUE(file().document);
    ASSERT_EQ(file().document->text(), file().text);
    Diagnostics diagnostics;
    const auto again = Document::FromText(file().text, kFile, diagnostics);
    ASSERT_TRUE(again) << diagnostics.ToString() << file().text;
    ASSERT_EQ(again->elements().size(), file().document->elements().size());
  }

  std::vector<ElementIndex> RandomSelection(const Document& document) {
    std::vector<ElementIndex> selection;
    for (std::size_t i = dice_.OneIn(4) ? 1 + dice_.Below(3) : 1; i > 0; --i) {
      selection.push_back(static_cast<ElementIndex>(dice_.Below(document.elements().size())));
    }
    return selection;
  }

  void RunOne() {
    const Document document = *file().document;
    Draft draft(document, RandomSelection(document));
    if (!RunCommand(draft)) return;
    Diagnostics diagnostics;
    ASSERT_TRUE(project_.Do({"Command", {std::move(draft).Finish(kFile)}}, {}, diagnostics))
        << diagnostics.ToString();
  }

  Outcome RunCommand(Draft& draft) {
    const auto element = static_cast<ElementIndex>(dice_.Below(draft.document().elements().size()));
    const auto position = static_cast<std::uint32_t>(dice_.Below(4));
    switch (dice_.Below(17)) {
      case 0:
        return InsertNodes(
            draft, rules_, element, position,
            {dice_.Pick({"<N/>", "<Sequence>\n  <A/>\n</Sequence>", "<M x='&lt;'/>"})});
      case 1:
        return dice_.OneIn(3) ? DeleteNodes(draft) : Problem{"rarely"};
      case 2:
        return DeleteKeepingChildren(draft, rules_);
      case 3:
        return MoveAmongSiblings(draft, dice_.OneIn(2) ? 1 : -1);
      case 4:
        return Promote(draft, rules_);
      case 5:
        return Demote(draft, rules_);
      case 6:
        return MoveInto(draft, rules_, element, position);
      case 7:
        return Wrap(draft, rules_, dice_.Pick({"<Fallback/>", R"(<Repeat num_cycles="3"/>)"}));
      case 8:
        return ChangeType(draft, rules_, dice_.Pick({"Fallback", "Unheard", "Wait", "Inverter"}));
      case 9:
        return ToggleDisabled(draft);
      case 10:
        return SetValue(draft, dice_.Pick({"name", "goal", "new"}),
                        dice_.Pick({"", "a < b", "{key}", "\"", "two\nlines", "\xC3\xA9"}));
      case 11:
        return ClearValue(draft, dice_.Pick({"name", "goal", "new"}));
      case 12:
        return ExtractSubTree(draft, rules_, "T" + std::to_string(draft.document().text().size()),
                              {});
      case 13:
        return Inline(draft);
      case 14:
        return DropNew(draft, rules_, Spot(element, position),
                       {dice_.Pick({"<N/>", "<Sequence/>", "<Inverter/>"})});
      case 15:
        return DropMoved(draft, rules_, Spot(element, position));
      default:
        return Paste(draft, element, position);
    }
  }

  DropSpot Spot(ElementIndex element, std::uint32_t position) {
    constexpr DropSpot::Kind kKinds[] = {DropSpot::Kind::kInto, DropSpot::Kind::kReplace,
                                         DropSpot::Kind::kAround};
    return {kKinds[dice_.Below(3)], element, position};
  }

  Outcome Inline(Draft& draft) {
    const std::vector<ElementIndex> selection = draft.selection();
    if (selection.empty()) return Problem{"nothing"};
    const Document document = draft.document();
    const ProjectFiles files = {document};
    const auto trees = TreesCalled(files, TypeOf(document, selection[0]));
    if (trees.empty() || document.text().size() > 200000) return Problem{"no tree"};
    return InlineSubTree(draft, rules_, document, trees[0].element);
  }

  Outcome Paste(Draft& draft, ElementIndex element, std::uint32_t position) {
    Diagnostics diagnostics;
    const std::string text = CopyText(draft.document(), draft.selection());
    const auto fragments = ReadFragments(text, diagnostics);
    if (diagnostics.has_errors()) return Problem{diagnostics.ToString()};
    if (text.size() > 2000) return Problem{"too long"};
    return InsertNodes(draft, rules_, element, position, fragments);
  }

  const std::string original_;
  const NodeRules& rules_;
  Dice& dice_;
  OpenProject project_;
};

int Count(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

TEST(RandomCommands, OnGeneratedTreesAreUndoneByteForByte) {
  const NodeModels models;
  const NodeRules rules(models);
  const auto count = static_cast<unsigned>(Count("COPPICE_RANDOM_TREES", 300));
  for (unsigned seed = 0; seed < count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    Session session(RandomFile(dice), rules, dice);
    ASSERT_TRUE(session.is_readable());
    session.Run(50);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(RandomCommands, OnRealFilesAreUndoneByteForByte) {
  const NodeModels models;
  const NodeRules rules(models);
  const char* folder = std::getenv("COPPICE_TREES");
  int sessions = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(folder ? folder : SourceFolder() + "/trees")) {
    if (entry.path().extension() != ".xml") continue;
    SCOPED_TRACE(entry.path().string());
    std::ifstream stream(entry.path(), std::ios::binary);
    Dice dice(static_cast<unsigned>(sessions));
    Session session({std::istreambuf_iterator<char>(stream), {}}, rules, dice);
    if (!session.is_readable()) continue;
    session.Run(50);
    if (testing::Test::HasFailure()) return;
    ++sessions;
  }
  EXPECT_GT(sessions, 0);
}

}  // namespace
}  // namespace coppice::editor
