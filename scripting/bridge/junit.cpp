// The schema is that of Jenkins' JUnit plugin, which the others follow.
#include "bridge/junit.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include <cairn/engine/utf8.h>

namespace cairn::scripting {
namespace {

/// What stands for bytes that are no UTF-8.
constexpr char32_t kReplacement = 0xFFFD;

/// For text and for attributes. XML 1.0 has no way to write most control characters: they become question
/// marks.
std::string escaped(const std::string& text) {
    std::string out;
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view from = rest;
        const char32_t c = engine::take_character(rest);
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\n':
                out += "&#10;";
                break;
            case '\t':
                out += "&#9;";
                break;
            case kReplacement:
                out += "\xEF\xBF\xBD";
                break;
            default:
                if (c < 0x20 || c == 0xFFFE || c == 0xFFFF)
                    out += '?';
                else
                    out += from.substr(0, from.size() - rest.size());
        }
    }
    return out;
}

std::string seconds(double duration_s) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", duration_s);
    return text;
}

/// name="..." tests="..." failures="..." time="..."
std::string totals(const std::string& name, const TestResult* first, const TestResult* last) {
    double duration_s = 0;
    for (const TestResult* result = first; result != last; ++result) duration_s += result->duration_s;
    const auto failures =
        std::count_if(first, last, [](const TestResult& result) { return result.error.has_value(); });
    return "name=\"" + escaped(name) + "\" tests=\"" + std::to_string(last - first) + "\" failures=\"" +
           std::to_string(failures) + "\" time=\"" + seconds(duration_s) + '"';
}

}  // namespace

std::string junit_xml(const std::string& game, const std::vector<TestResult>& results) {
    const TestResult* const end = results.data() + results.size();
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " +
                      totals(game, results.data(), end) + ">\n";
    for (const TestResult* first = results.data(); first != end;) {
        const TestResult* last =
            std::find_if(first, end, [&](const TestResult& result) { return result.file != first->file; });
        xml += "  <testsuite " + totals(first->file, first, last) + ">\n";
        for (; first != last; ++first) {
            xml += "    <testcase classname=\"" + escaped(game + '.' + first->file) + "\" name=\"" +
                   escaped(first->name) + "\" time=\"" + seconds(first->duration_s) + '"';
            if (!first->error) {
                xml += "/>\n";
                continue;
            }
            xml += ">\n      <failure message=\"" + escaped(first->error->message) + "\">" +
                   escaped(first->error->to_text()) + "</failure>\n    </testcase>\n";
        }
        xml += "  </testsuite>\n";
    }
    return xml + "</testsuites>\n";
}

}  // namespace cairn::scripting
