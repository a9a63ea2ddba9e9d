#include "motion/formats/mvnx/xml_events.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <memory>
#include <new>

#include <expat.h>

namespace mien::motion {

namespace {

constexpr std::string_view obtain_xml_again = "obtain or export the file again";

/// A parser and what it calls. Exceptions must not pass through expat: the first is kept here.
struct Parsing {
  XML_Parser parser;
  XmlEvents& events;
  const TextCursor& cursor;
  std::exception_ptr thrown;

  size_t place() const {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
    const std::int64_t index = XML_GetCurrentByteIndex64(parser);
#else
    const std::int64_t index = XML_GetCurrentByteIndex(parser);
#endif
    return std::min(static_cast<size_t>(std::max<std::int64_t>(index, 0)), cursor.text.size());
  }
};

template <typename Call>
void guarded(void* user, Call call) {
  auto& parsing = *static_cast<Parsing*>(user);
  if (parsing.thrown) return;  // expat may call once more after it was stopped
  try {
    call(parsing);
  } catch (...) {
    parsing.thrown = std::current_exception();
    XML_StopParser(parsing.parser, XML_FALSE);
  }
}

void XMLCALL on_start(void* user, const XML_Char* name, const XML_Char** attributes) {
  guarded(user, [&](Parsing& parsing) {
    std::string_view local = name;
    local.remove_prefix(local.find(':') + 1);
    parsing.events.start(local, XmlAttributes(attributes), parsing.place());
  });
}

void XMLCALL on_text(void* user, const XML_Char* characters, int count) {
  guarded(user, [&](Parsing& parsing) {
    parsing.events.text({characters, static_cast<size_t>(count)});
  });
}

void XMLCALL on_end(void* user, const XML_Char*) {
  guarded(user, [&](Parsing& parsing) { parsing.events.end(); });
}

void XMLCALL on_document_type(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
  guarded(user, [&](Parsing& parsing) {
    fail(parsing.cursor, parsing.place(), "a document type (DOCTYPE) is declared",
         "remove the declaration: it is not needed, and could make the file grow without limit");
  });
}

[[noreturn]] void refuse(const Parsing& parsing) {
  if (parsing.thrown) std::rethrow_exception(parsing.thrown);
  const XML_Error error = XML_GetErrorCode(parsing.parser);
  if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
  const bool is_cut = error == XML_ERROR_NO_ELEMENTS || error == XML_ERROR_UNCLOSED_TOKEN ||
                      error == XML_ERROR_PARTIAL_CHAR || error == XML_ERROR_UNCLOSED_CDATA_SECTION;
  if (is_cut) fail(parsing.cursor, parsing.place(), "the file is truncated", obtain_xml_again);
  fail(parsing.cursor, parsing.place(),
       std::string("this is not well-formed XML (") + XML_ErrorString(error) + ")",
       obtain_xml_again);
}

}  // namespace

void parse_xml(const TextCursor& cursor, XmlEvents& events) {
  // A tag is parsed again from its start with each piece, so pieces are long and tags limited.
  constexpr size_t piece = size_t{256} << 10;
  constexpr size_t longest_tag = size_t{1} << 20;
  const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(nullptr), &XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Parsing parsing{parser.get(), events, cursor, nullptr};
  XML_SetUserData(parser.get(), &parsing);
  XML_SetElementHandler(parser.get(), on_start, on_end);
  XML_SetCharacterDataHandler(parser.get(), on_text);
  XML_SetStartDoctypeDeclHandler(parser.get(), on_document_type);
  for (size_t at = 0; at == 0 || at < cursor.text.size(); at += piece) {
    const std::string_view part = cursor.text.substr(at, piece);
    const bool is_last = at + part.size() == cursor.text.size();
    if (XML_Parse(parser.get(), part.data(), static_cast<int>(part.size()), is_last) !=
        XML_STATUS_OK)
      refuse(parsing);
    if (at + part.size() > parsing.place() + longest_tag + piece)
      fail(cursor, parsing.place(), "a tag or comment of more than 1 MiB", obtain_xml_again);
  }
}

}  // namespace mien::motion
