// Lines are the wrong pieces for XML: two people who each give a node another attribute would be in
// conflict. The pieces are tags without their attributes, attributes, and texts between tags, each
// with the blanks before it, so that what is put together again is the user's text byte for byte.
#include "editor/files/merge.h"

#include <algorithm>

#include "bt_core/model/xml_text.h"

namespace coppice::editor {
namespace {

using Pieces = std::vector<std::string_view>;

constexpr int kMostDifferences = 2000;  // beyond it, the middle counts as changed as a whole

class Splitter {
 public:
  explicit Splitter(std::string_view text) : text_(text) {}

  Pieces Run() {
    while (at_ < text_.size()) {
      if (text_[at_] != '<') {
        Take(std::min(text_.find('<', at_), text_.size()));
      } else if (!TakeUntil("<!--", "-->") && !TakeUntil("<![CDATA[", "]]>") &&
                 !TakeUntil("<?", "?>") && !TakeUntil("</", ">") && !TakeUntil("<!", ">")) {
        TakeTag();
      }
    }
    return std::move(pieces_);
  }

 private:
  void Take(std::size_t end) {
    pieces_.push_back(text_.substr(at_, end - at_));
    at_ = end;
  }

  bool TakeUntil(std::string_view open, std::string_view close) {
    if (text_.compare(at_, open.size(), open) != 0) return false;
    const std::size_t end = text_.find(close, at_ + open.size());
    Take(end == std::string_view::npos ? text_.size() : end + close.size());
    return true;
  }

  // "<Tag", then attributes with the blanks before them, then the end with those before it.
  void TakeTag() {
    Take(at_ + 1 + NameLength(text_.substr(at_ + 1)));
    while (at_ < text_.size()) {
      const std::size_t start = std::min(text_.find_first_not_of(kXmlBlanks, at_), text_.size());
      if (start == text_.size() || text_[start] == '<') return;
      if (text_[start] == '>') return Take(start + 1);
      if (text_.compare(start, 2, "/>") == 0) return Take(start + 2);
      Take(EndOfAttribute(start));
    }
  }

  std::size_t EndOfAttribute(std::size_t start) const {
    const std::size_t quote = text_.find_first_of("\"'<>", start);
    if (quote == std::string_view::npos) return text_.size();
    if (text_[quote] == '<' || text_[quote] == '>') return std::max(quote, start + 1);
    const std::size_t end = text_.find(text_[quote], quote + 1);
    return end == std::string_view::npos ? text_.size() : end + 1;
  }

  const std::string_view text_;
  std::size_t at_ = 0;
  Pieces pieces_;
};

// E. W. Myers, "An O(ND) difference algorithm and its variations", Algorithmica 1, 1986, on what is
// between the common start and the common end.
class Matcher {
 public:
  Matcher(const Pieces& before, const Pieces& after)
      : before_(before), after_(after), match_(before.size(), -1) {}

  std::vector<int> Run() {
    int a_end = static_cast<int>(before_.size());
    int b_end = static_cast<int>(after_.size());
    while (start_ < a_end && start_ < b_end && Same(start_, start_)) {
      match_[At(start_)] = start_;
      ++start_;
    }
    while (a_end > start_ && b_end > start_ && Same(a_end - 1, b_end - 1)) {
      match_[At(--a_end)] = --b_end;
    }
    a_size_ = a_end - start_;
    b_size_ = b_end - start_;
    Walk();
    return std::move(match_);
  }

 private:
  static std::size_t At(int index) { return static_cast<std::size_t>(index); }
  bool Same(int a, int b) const { return before_[At(a)] == after_[At(b)]; }

  void Walk() {
    const int most = std::min(a_size_ + b_size_, kMostDifferences);
    std::vector<int> furthest(At(2 * most + 3), 0);  // by diagonal
    const auto diagonal = [most](int k) { return At(k + most + 1); };
    for (int d = 0; d <= most; ++d) {
      trace_.push_back(furthest);
      for (int k = -d; k <= d; k += 2) {
        const bool down =
            k == -d || (k != d && furthest[diagonal(k - 1)] < furthest[diagonal(k + 1)]);
        int x = down ? furthest[diagonal(k + 1)] : furthest[diagonal(k - 1)] + 1;
        while (x < a_size_ && x - k < b_size_ && Same(start_ + x, start_ + x - k)) ++x;
        furthest[diagonal(k)] = x;
        if (x >= a_size_ && x - k >= b_size_) return Back(d, most);
      }
    }
  }

  void Back(int d, int most) {
    int x = a_size_;
    int y = b_size_;
    for (; d >= 0; --d) {
      const std::vector<int>& furthest = trace_[At(d)];
      const auto diagonal = [most](int k) { return At(k + most + 1); };
      const int k = x - y;
      const bool down =
          k == -d || (k != d && furthest[diagonal(k - 1)] < furthest[diagonal(k + 1)]);
      const int from_k = down ? k + 1 : k - 1;
      const int from_x = d == 0 ? 0 : furthest[diagonal(from_k)];
      const int from_y = d == 0 ? 0 : from_x - from_k;
      while (x > from_x && y > from_y) match_[At(start_ + --x)] = start_ + --y;
      x = from_x;
      y = from_y;
    }
  }

  const Pieces& before_;
  const Pieces& after_;
  std::vector<int> match_;
  int start_ = 0;
  int a_size_ = 0;
  int b_size_ = 0;
  std::vector<std::vector<int>> trace_;
};

struct Range {
  int begin = 0;
  int end = 0;
};

class Merger {
 public:
  Merger(std::string_view before, std::string_view mine, std::string_view theirs)
      : before_(XmlPieces(before)),
        mine_(XmlPieces(mine)),
        theirs_(XmlPieces(theirs)),
        in_mine_(MatchPieces(before_, mine_)),
        in_theirs_(MatchPieces(before_, theirs_)) {}

  MergedText Run() {
    Range b, m, t;
    const int size = static_cast<int>(before_.size());
    while (true) {
      while (b.end < size && !IsSync(b.end, m.begin, t.begin)) ++b.end;
      const bool last = b.end == size;
      m.end = last ? static_cast<int>(mine_.size()) : in_mine_[At(b.end)];
      t.end = last ? static_cast<int>(theirs_.size()) : in_theirs_[At(b.end)];
      Put(b, m, t);
      if (last) return std::move(result_);
      result_.text += before_[At(b.end)];
      b = {b.end + 1, b.end + 1};
      m = {m.end + 1, m.end + 1};
      t = {t.end + 1, t.end + 1};
    }
  }

 private:
  static std::size_t At(int index) { return static_cast<std::size_t>(index); }

  bool IsSync(int b, int mine, int theirs) const {
    return in_mine_[At(b)] >= mine && in_theirs_[At(b)] >= theirs;
  }

  static std::string Text(const Pieces& pieces, Range range) {
    std::string text;
    for (int i = range.begin; i < range.end; ++i) text += pieces[At(i)];
    return text;
  }

  // Neighbours that were changed one by one, such as attributes, have nothing in common between
  // them: they are compared one by one.
  void Put(Range b, Range m, Range t) {
    const int size = b.end - b.begin;
    if (m.end - m.begin != size || t.end - t.begin != size) {
      return Put(Text(before_, b), Text(mine_, m), Text(theirs_, t));
    }
    for (int i = 0; i < size; ++i) {
      Put(std::string(before_[At(b.begin + i)]), std::string(mine_[At(m.begin + i)]),
          std::string(theirs_[At(t.begin + i)]));
    }
  }

  void Put(const std::string& before, std::string mine, std::string theirs) {
    if (mine == before) {
      result_.text += theirs;
      return;
    }
    const auto offset = static_cast<std::uint32_t>(result_.text.size());
    result_.text += mine;
    if (theirs == before || theirs == mine) return;
    result_.conflicts.push_back({offset, std::move(mine), std::move(theirs)});
  }

  const Pieces before_, mine_, theirs_;
  const std::vector<int> in_mine_, in_theirs_;
  MergedText result_;
};

}  // namespace

std::vector<std::string_view> XmlPieces(std::string_view text) { return Splitter(text).Run(); }

std::vector<int> MatchPieces(const std::vector<std::string_view>& before,
                             const std::vector<std::string_view>& after) {
  return Matcher(before, after).Run();
}

MergedText MergeTexts(std::string_view before, std::string_view mine, std::string_view theirs) {
  return Merger(before, mine, theirs).Run();
}

}  // namespace coppice::editor
