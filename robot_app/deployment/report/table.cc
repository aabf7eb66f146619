#include "robot_app/deployment/report/table.h"

#include <cstdio>

#include "bt_core/engine/compile/models.h"

namespace coppice::robot::deployment {
namespace {

std::string MarkdownRow(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

std::string HtmlRow(const std::vector<std::string>& cells, const char* tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) {
    row += std::string("<") + tag + ">" + EscapeXml(cell) + "</" + tag + ">";
  }
  return row + "</tr>\n";
}

}  // namespace

std::string Printed(const char* format, double number) {
  char text[64];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

std::string ToMarkdown(const Table& table) {
  std::string text = "## " + table.title + "\n\n" + MarkdownRow(table.head);
  text += MarkdownRow(std::vector<std::string>(table.head.size(), "---"));
  for (const auto& row : table.rows) text += MarkdownRow(row);
  return text + "\n" + (table.note.empty() ? "" : table.note + "\n\n");
}

std::string ToHtml(const Table& table) {
  std::string text =
      "<h2>" + EscapeXml(table.title) + "</h2>\n<table>\n" + HtmlRow(table.head, "th");
  for (const auto& row : table.rows) text += HtmlRow(row, "td");
  return text + "</table>\n" + (table.note.empty() ? "" : "<p>" + EscapeXml(table.note) + "</p>\n");
}

}  // namespace coppice::robot::deployment
