// What must hold for every edit of every document: undo restores each byte, the result parses, and
// one attribute is one line.
#include <algorithm>
#include <random>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/layout.h"
#include "tests/bt_core/model/edited.h"

namespace coppice {
namespace {

class RandomDocument {
 public:
  explicit RandomDocument(unsigned seed) : random_(seed) {
    line_end_ = Chance(2) ? "\n" : "\r\n";
    step_ = Pick({"  ", "\t", " "});
    on_lines_ = !Chance(5);
  }

  std::string Text() {
    std::string text = Pick({"", "\xEF\xBB\xBF", "<?xml version=\"1.0\"?>\n", "<!-- top -->\r\n"});
    AddElement(text, 0);
    return text + Pick({"", "\n", "\r\n  ", "<!-- end -->"});
  }

  std::size_t Uniform(std::size_t below) { return random_() % below; }
  bool Chance(unsigned one_in) { return Uniform(one_in) == 0; }
  std::string Pick(const std::vector<std::string>& choices) {
    return choices[Uniform(choices.size())];
  }
  std::string Name() { return Pick({"a", "Sequence", "_x", "T\xC3\xBCr", "n1.b-c"}); }
  std::string Value() {
    std::string value;
    for (std::size_t i = Uniform(6); i > 0; --i) {
      value += Pick({"a", " ", "<", ">", "&", "&&", "\"", "'", "&lt;", "\n", "\xC3\xA9", "{k}"});
    }
    return value;
  }

 private:
  void NewLine(std::string& text, int depth) {
    if (!on_lines_ || Chance(12)) return;
    text += line_end_;
    for (int i = 0; i < depth; ++i) text += step_;
  }

  void AddElement(std::string& text, int depth) {
    const std::string name = Name();
    text += "<" + name;
    const char quote = Chance(2) ? '"' : '\'';
    for (std::size_t i = Uniform(4); i > 0; --i) {
      text += Pick({" ", "  ", "\n   "}) + "p" + std::to_string(i) + Pick({"=", " = "}) + quote +
              Pick({"1", "a &lt; b && c", "two\nlines", "{key}", ">", ""}) + quote;
    }
    if (depth == 5 || Chance(3)) {
      text += Pick({"/>", " />"});
      return;
    }
    text += ">";
    for (std::size_t i = Uniform(4); i > 0; --i) {
      if (Chance(4)) {
        NewLine(text, depth + 1);
        text += Pick({"<!-- c\n   d -->", "words", "<![CDATA[<x>]]>"});
      }
      NewLine(text, depth + 1);
      AddElement(text, depth + 1);
      if (Chance(8)) text += " <!-- behind -->";
    }
    NewLine(text, depth);
    text += "</" + name + Pick({">", " >"});
  }

  std::mt19937 random_;
  std::string line_end_;
  std::string step_;
  bool on_lines_ = true;
};

std::size_t Lines(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

// Lines that differ, for texts of the same number of lines.
std::size_t ChangedLines(std::string_view a, std::string_view b) {
  std::size_t changed = 0;
  while (!a.empty() || !b.empty()) {
    const std::size_t end_a = std::min(a.find('\n'), a.size() - 1) + 1;
    const std::size_t end_b = std::min(b.find('\n'), b.size() - 1) + 1;
    if (a.substr(0, end_a) != b.substr(0, end_b)) ++changed;
    a.remove_prefix(end_a);
    b.remove_prefix(end_b);
  }
  return changed;
}

Edit AnyEdit(const Document& document, RandomDocument& random) {
  const auto element = static_cast<ElementIndex>(random.Uniform(document.elements().size()));
  const auto other = static_cast<ElementIndex>(random.Uniform(document.elements().size()));
  const auto position = static_cast<std::uint32_t>(random.Uniform(4));
  const Element& e = document.element(element);
  const std::string name =
      e.attribute_count > 0
          ? std::string(document.attributes_begin(e)[random.Uniform(e.attribute_count)].name)
          : "none";
  switch (random.Uniform(10)) {
    case 0:
      return SetAttribute(document, element, name, random.Value());
    case 1:
      return SetAttribute(document, element, "new" + std::to_string(position), random.Value());
    case 2:
      return RemoveAttribute(document, element, name);
    case 3:
      return RenameAttribute(document, element, name,
                             "r" + std::to_string(random.Uniform(1000000)));
    case 4:
      return SetTag(document, element, random.Name());
    case 5:
      return InsertElement(document, element, position, "<N y='1'>\n  <M/>\n</N>");
    case 6:
      return RemoveElement(document, element);
    case 7:
      return MoveElement(document, element, other, position);
    case 8:
      return WrapElements(document, element, position, "W");
    default:
      return element == 0 ? ReplaceElement(document, kRootElement, "<root><a/><b>\n</b></root>")
                          : UnwrapElement(document, element);
  }
}

TEST(RandomEdits, AreUndoneByteForByteInTheOppositeOrder) {
  int edits = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    RandomDocument random(seed);
    const std::string original = random.Text();
    Document document = Parsed(original);
    ASSERT_EQ(document.text(), original) << "parsing keeps the text";
    std::vector<Edit> undo;
    for (int step = 0; step < 25; ++step) {
      const Edit edit = AnyEdit(document, random);
      undo.push_back(Inverse(edit, document.text()));
      Diagnostics diagnostics;
      auto edited = document.Edited(edit, diagnostics);
      ASSERT_TRUE(edited) << "seed " << seed << " step " << step << "\n"
                          << document.text() << "\n-->\n"
                          << Apply(edit, document.text()) << "\n"
                          << diagnostics.ToString();
      document = *std::move(edited);
      edits += edit.empty() ? 0 : 1;
    }
    std::string text = document.text();
    for (; !undo.empty(); undo.pop_back()) text = Apply(undo.back(), text);
    ASSERT_EQ(text, original) << "seed " << seed;
  }
  EXPECT_GT(edits, 6000);
}

TEST(RandomEdits, OneAttributeIsOneLine) {
  int changes = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    RandomDocument random(seed);
    const Document document = Parsed(random.Text());
    const auto element = static_cast<ElementIndex>(random.Uniform(document.elements().size()));
    const Element& e = document.element(element);
    if (e.attribute_count == 0) continue;
    const Attribute& attribute = document.attributes_begin(e)[random.Uniform(e.attribute_count)];
    if (document.RawValue(attribute).find('\n') != std::string_view::npos) continue;
    const std::string value = random.Value();
    const std::string after =
        After(document, SetAttribute(document, element, attribute.name, value));
    ASSERT_EQ(Lines(after), Lines(document.text()));
    ASSERT_LE(ChangedLines(document.text(), after), 1U);
    ASSERT_EQ(Parsed(after).AttributeValue(Parsed(after).element(element), attribute.name), value);
    ++changes;
  }
  EXPECT_GT(changes, 500);
}

TEST(RandomEdits, AMovedElementKeepsItsAttributesAndTheOthersTheirOrder) {
  const auto tags = [](const Document& document) {
    std::vector<std::string> all;
    for (const Element& e : document.elements()) {
      std::string text(e.tag);
      for (const Attribute* a = document.attributes_begin(e); a != document.attributes_end(e);
           ++a) {
        text += "|" + std::string(a->name) + "=" + std::string(a->value);
      }
      all.push_back(text);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  for (unsigned seed = 0; seed < 2000; ++seed) {
    RandomDocument random(seed);
    const Document document = Parsed(random.Text());
    const auto count = document.elements().size();
    const auto element = static_cast<ElementIndex>(random.Uniform(count));
    const auto parent = static_cast<ElementIndex>(random.Uniform(count));
    const auto position = static_cast<std::uint32_t>(random.Uniform(4));
    if (element == 0) continue;
    const Document after =
        Parsed(After(document, MoveElement(document, element, parent, position)));
    ASSERT_EQ(tags(after), tags(document)) << "seed " << seed;
  }
}

TEST(RandomEdits, AMovedElementIsThenTheChildAtThatPosition) {
  int moves = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    RandomDocument random(seed);
    Document document = Parsed(random.Text());
    const auto count = document.elements().size();
    const auto element = static_cast<ElementIndex>(random.Uniform(count));
    const auto parent = static_cast<ElementIndex>(random.Uniform(count));
    const auto position = static_cast<std::uint32_t>(random.Uniform(4));
    if (element == parent) continue;
    document = Parsed(After(document, SetAttribute(document, element, "marked", "moved")));
    document = Parsed(After(document, SetAttribute(document, parent, "marked", "parent")));
    const Edit edit = MoveElement(document, element, parent, position);
    if (edit.empty()) continue;
    const Document after = Parsed(After(document, edit));
    ElementIndex target{0};
    while (after.AttributeValue(after.element(target), "marked") != "parent") ++target;
    ElementIndex child = after.element(target).first_child;
    for (std::uint32_t i = 0; i < position; ++i) {
      if (after.element(child).next_sibling == kNoElement) break;
      child = after.element(child).next_sibling;
    }
    ASSERT_EQ(after.AttributeValue(after.element(child), "marked"), "moved") << "seed " << seed;
    ++moves;
  }
  EXPECT_GT(moves, 300);
}

}  // namespace
}  // namespace coppice
