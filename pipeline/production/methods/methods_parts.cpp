#include "pipeline/production/methods/methods_parts.h"

namespace mien::pipeline {

void MethodsText::say(const std::string& sentence) {
  if (!text_.ends_with("\n")) text_ += " ";
  text_ += sentence + ".";
}

void MethodsText::end_paragraph() { text_ += text_.ends_with(".") ? "\n\n" : ""; }

std::string MethodsText::cite(const Names& keys) {
  if (keys.empty()) return "";
  std::string text;
  for (const std::string& key : keys) {
    text += (text.empty() ? "@" : "; @") + key;
    add_once(cited_, key);
  }
  return " [" + text + "]";
}

}  // namespace mien::pipeline
