#include "api/hair_bytes.hpp"

#include <nlohmann/json.hpp>

#include "api/tuft_text.hpp"
#include "api/write_nouns.hpp"
#include "gltf/json_text.hpp"
#include "version.hpp"

namespace tuftwave::server {
namespace {

std::string text_of(const nlohmann::ordered_json& part) { return gltf::extras_text(nlohmann::json(part)); }

/// Everything that was asked for, its keys in alphabetical order; tuft by tuft, since all of them as values are 30
/// times their text.
std::string hairstyle_text(const HairRequest& hair) {
    std::string text = text_of(settings_json(hair.hairstyle, hair.look));
    text.back() = ',';  // in place of the brace
    text += "\"tufts\":";
    char mark = '[';
    for (const Tuft& tuft : hair.hairstyle.tufts) {
        text += mark;
        append_tuft(text, tuft);
        mark = ',';
    }
    text += "]}";
    return text;
}

std::string asset_extras(const HairRequest& hair, const HairPlan& plan) {
    const Schedule* schedule = plan.motion ? &plan.motion->schedule : nullptr;
    const nlohmann::ordered_json warnings = warnings_json(schedule, plan.fills);
    std::string text = "{\"tuftwave\":{\"hairstyle\":" + hairstyle_text(hair);
    if (schedule != nullptr) text += ",\"schedule\":" + text_of(schedule_json(*schedule));
    text += ",\"version\":" + nlohmann::json(kVersion).dump();
    if (schedule != nullptr || !warnings.empty()) text += ",\"warnings\":" + text_of(warnings);
    text += "}}";
    return text;
}

}  // namespace

gltf::File hair_bytes(const HairRequest& hair, const HairPlan& plan, Format format, const Context& context,
                      const FileOptions& options) {
    const nlohmann::json clip = plan.motion ? nlohmann::json(schedule_json(plan.motion->schedule)) : nlohmann::json();
    const auto container = format == Format::kGlb ? gltf::Container::kGlb : gltf::Container::kGltf;
    return gltf::hair_file(plan, hair.look, asset_extras(hair, plan), {clip, options.holding, options.kind}, container,
                           options.compression, context.for_each, context.stop);
}

}  // namespace tuftwave::server
