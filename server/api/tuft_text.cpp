#include "api/tuft_text.hpp"

#include "api/choices.hpp"
#include "gltf/json_text.hpp"

namespace tuftwave::server {
namespace {

// Bytes that are written at most: of a number and the comma behind it, of a character, of keys, words and brackets.
constexpr std::size_t kNumberBytes = 27, kCharacterBytes = 6, kOtherBytes = 512;

std::size_t most_bytes(const Tuft& tuft) {
    return tuft.points.size() * (3 * kNumberBytes + 3) + tuft.name.size() * kCharacterBytes + kOtherBytes;
}

void write_origin(gltf::JsonText& to, const Origin& origin) {
    to.key("origin").open('{').key("index").number(origin.index);
    to.key("kind").text(std::string(word_of(kFillKinds, origin.kind)));
    if (origin.parent) to.key("parent").number(*origin.parent);
    to.close('}');
}

}  // namespace

void append_tuft(std::string& out, const Tuft& tuft) {
    const std::size_t before = out.size();
    out.resize(before + most_bytes(tuft));
    gltf::JsonText text(out.data() + before);
    text.open('{');
    if (tuft.cycles) text.key("cycles").number(*tuft.cycles);
    text.key("diameter").number(tuft.diameter).key("flatness").number(tuft.flatness);
    text.key("joints").number(tuft.joints).key("name").text(tuft.name);
    if (tuft.origin) write_origin(text, *tuft.origin);
    text.key("phase").number(tuft.phase).key("points").open('[');
    for (const Vec3& point : tuft.points) {
        text.next().open('[').next().number(point.x).next().number(point.y).next().number(point.z).close(']');
    }
    text.close(']').key("roll_deg").number(tuft.roll_deg);
    text.key("section")
        .text(std::string(word_of(kSections, tuft.section)))
        .key("taper")
        .text(std::string(word_of(kTapers, tuft.taper)));
    text.key("twist_deg").number(tuft.twist_deg).key("widest_at").number(tuft.widest_at).close('}');
    out.resize(before + text.bytes());
}

}  // namespace tuftwave::server
