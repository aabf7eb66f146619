#include "robot_app/slam/pictures/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <set>
#include <sstream>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot::slam {
namespace {

constexpr int kRounds = 8;  // of k-medians
constexpr char kHeader[] = "coppice vocabulary 1";
constexpr std::size_t kMostNodes = 200000;

using Group = std::vector<const Descriptor*>;

// The bits that most of a group have.
Descriptor MedianOf(const Group& group) {
  Descriptor median{};
  for (std::size_t bit = 0; bit < 256; ++bit) {
    std::size_t set = 0;
    for (const Descriptor* descriptor : group) set += (*descriptor)[bit / 64] >> (bit % 64) & 1;
    if (2 * set > group.size()) median[bit / 64] |= std::uint64_t{1} << (bit % 64);
  }
  return median;
}

std::size_t NearestOf(const std::vector<Descriptor>& centers, const Descriptor& descriptor) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < centers.size(); ++i) {
    if (Difference(centers[i], descriptor) < Difference(centers[nearest], descriptor)) nearest = i;
  }
  return nearest;
}

// Some of the group, the farther from those before, the likelier (k-means++).
std::vector<Descriptor> FirstCenters(const Group& group, std::size_t count,
                                     std::mt19937_64& random) {
  std::vector<Descriptor> centers{*group[random() % group.size()]};
  while (centers.size() < count) {
    std::vector<std::uint64_t> sums;
    std::uint64_t sum = 0;
    for (const Descriptor* descriptor : group) {
      const auto off = static_cast<std::uint64_t>(
          Difference(centers[NearestOf(centers, *descriptor)], *descriptor));
      sums.push_back(sum += off * off);
    }
    if (sum == 0) break;
    const auto drawn = std::upper_bound(sums.begin(), sums.end(), random() % sum);
    centers.push_back(*group[static_cast<std::size_t>(drawn - sums.begin())]);
  }
  return centers;
}

struct Parts {
  std::vector<Descriptor> centers;
  std::vector<Group> groups;  // none is empty
};

Parts Divide(const Group& group, std::size_t count, std::mt19937_64& random) {
  Parts parts{FirstCenters(group, count, random), {}};
  for (int round = 0; round < kRounds; ++round) {
    parts.groups.assign(parts.centers.size(), {});
    for (const Descriptor* descriptor : group) {
      parts.groups[NearestOf(parts.centers, *descriptor)].push_back(descriptor);
    }
    parts.groups.erase(std::remove_if(parts.groups.begin(), parts.groups.end(),
                                      [](const Group& part) { return part.empty(); }),
                       parts.groups.end());
    parts.centers.clear();
    for (const Group& part : parts.groups) parts.centers.push_back(MedianOf(part));
  }
  return parts;
}

}  // namespace

Expected<Vocabulary> Vocabulary::Train(const std::vector<std::vector<Descriptor>>& pictures,
                                       const Training& training) {
  struct Open {
    std::uint32_t node;
    int depth;
    Group group;
  };
  Open root{0, 0, {}};
  for (const auto& picture : pictures) {
    for (const Descriptor& descriptor : picture) root.group.push_back(&descriptor);
  }
  const auto branches = static_cast<std::size_t>(training.branches);
  if (root.group.size() < branches) {
    return Problem{"to learn a vocabulary, at least " + std::to_string(branches) +
                   " corners are needed; there are " + std::to_string(root.group.size())};
  }
  std::mt19937_64 random(training.seed);
  Vocabulary vocabulary;
  vocabulary.nodes_.emplace_back();
  std::vector<Open> open{std::move(root)};
  for (std::size_t next = 0; next < open.size(); ++next) {
    const Open here = std::move(open[next]);
    Node& node = vocabulary.nodes_[here.node];
    if (here.depth == training.depth || here.group.size() < 2 * branches) {
      node.word = vocabulary.words_++;
      continue;
    }
    Parts parts = Divide(here.group, branches, random);
    node.first_child = static_cast<std::uint32_t>(vocabulary.nodes_.size());
    node.children = static_cast<std::uint32_t>(parts.groups.size());
    for (std::size_t i = 0; i < parts.groups.size(); ++i) {
      const auto child = static_cast<std::uint32_t>(vocabulary.nodes_.size());
      vocabulary.nodes_.push_back({parts.centers[i], 0, 0, 0, 0});
      open.push_back({child, here.depth + 1, std::move(parts.groups[i])});
    }
  }
  vocabulary.Weigh(pictures);
  return vocabulary;
}

// log(pictures / pictures with the word)
void Vocabulary::Weigh(const std::vector<std::vector<Descriptor>>& pictures) {
  std::vector<int> seen_in(words_, 0);
  for (const auto& picture : pictures) {
    std::set<std::uint32_t> words;
    for (const Descriptor& descriptor : picture) words.insert(WordOf(descriptor));
    for (const std::uint32_t word : words) ++seen_in[word];
  }
  for (Node& node : nodes_) {
    if (node.children > 0) continue;
    const double count = std::max(seen_in[node.word], 1);
    node.weight = static_cast<float>(std::log(static_cast<double>(pictures.size() + 1) / count));
  }
}

const Vocabulary::Node& Vocabulary::LeafOf(const Descriptor& descriptor) const {
  const Node* node = &nodes_[0];
  while (node->children > 0) {
    const Node* nearest = &nodes_[node->first_child];
    int least = Difference(nearest->center, descriptor);
    for (std::uint32_t i = 1; i < node->children; ++i) {
      const Node& child = nodes_[node->first_child + i];
      const int off = Difference(child.center, descriptor);
      if (off >= least) continue;
      least = off;
      nearest = &child;
    }
    node = nearest;
  }
  return *node;
}

std::uint32_t Vocabulary::WordOf(const Descriptor& descriptor) const {
  return LeafOf(descriptor).word;
}

BagOfWords Vocabulary::BagOf(const std::vector<Descriptor>& descriptors) const {
  std::vector<WeighedWord> found;
  float sum = 0;
  for (const Descriptor& descriptor : descriptors) {
    const Node& leaf = LeafOf(descriptor);
    found.push_back({leaf.word, leaf.weight});
    sum += leaf.weight;
  }
  std::sort(found.begin(), found.end(),
            [](const WeighedWord& a, const WeighedWord& b) { return a.word < b.word; });
  BagOfWords bag;
  for (const WeighedWord& word : found) {
    if (bag.empty() || bag.back().word != word.word) bag.push_back({word.word, 0});
    bag.back().weight += word.weight / std::max(sum, 1e-9F);
  }
  return bag;
}

// A line for each node: children, weight, description.
Outcome Vocabulary::Save(const std::string& file) const {
  std::string text = std::string(kHeader) + "\n" + std::to_string(nodes_.size()) + "\n";
  for (const Node& node : nodes_) {
    char line[128];
    std::snprintf(line, sizeof(line), "%u %.5f %016llx%016llx%016llx%016llx\n", node.children,
                  static_cast<double>(node.weight), static_cast<unsigned long long>(node.center[0]),
                  static_cast<unsigned long long>(node.center[1]),
                  static_cast<unsigned long long>(node.center[2]),
                  static_cast<unsigned long long>(node.center[3]));
    text += line;
  }
  Diagnostics diagnostics;
  if (WriteFile(file, text, diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

Expected<Vocabulary> Vocabulary::Load(const std::string& file) {
  const auto text = ReadFile(file);
  if (!text) return Problem{file + ": cannot be read"};
  std::istringstream lines(*text);
  std::string line;
  std::getline(lines, line);
  const auto wrong = [&file](std::size_t at, const char* expected) {
    return Problem{file + ":" + std::to_string(at) + ": expected " + expected +
                   ", as `coppice-train vocabulary` writes it"};
  };
  if (line != kHeader) return wrong(1, kHeader);
  std::size_t count = 0;
  std::getline(lines, line);
  if (std::sscanf(line.c_str(), "%zu", &count) != 1 || count == 0 || count > kMostNodes) {
    return wrong(2, "the number of nodes");
  }
  Vocabulary vocabulary;
  std::size_t next_child = 1;
  for (std::size_t i = 0; i < count; ++i) {
    Node node;
    unsigned long long part[4] = {};
    if (!std::getline(lines, line) ||
        std::sscanf(line.c_str(), "%u %f %16llx%16llx%16llx%16llx", &node.children, &node.weight,
                    &part[0], &part[1], &part[2], &part[3]) != 6 ||
        !std::isfinite(node.weight) || node.children > count - next_child) {
      return wrong(i + 3, "children, weight and description of a node");
    }
    std::copy(std::begin(part), std::end(part), node.center.begin());
    if (node.children > 0) {
      node.first_child = static_cast<std::uint32_t>(next_child);
      next_child += node.children;
    } else {
      node.word = vocabulary.words_++;
    }
    vocabulary.nodes_.push_back(node);
  }
  if (next_child != count) return wrong(count + 2, "each node to be a child of one before it");
  return vocabulary;
}

}  // namespace coppice::robot::slam
