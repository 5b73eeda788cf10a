#include "api/hair_bytes.hpp"

#include <nlohmann/json.hpp>

#include "api/hairstyle_text.hpp"
#include "api/write_nouns.hpp"
#include "gltf/json_text.hpp"
#include "version.hpp"

namespace tuftwave::server {
namespace {

std::string text_of(const nlohmann::ordered_json& part) { return gltf::extras_text(nlohmann::json(part)); }

/// What a file says about itself, its keys in alphabetical order.
std::string asset_extras(const HairRequest& hair, const HairPlan& plan, const ForEach& for_each) {
    const Schedule* schedule = plan.motion ? &plan.motion->schedule : nullptr;
    const nlohmann::ordered_json warnings = warnings_json(schedule, plan.fills);
    std::string text = "{\"tuftwave\":{\"hairstyle\":";
    append_hairstyle(text, hair.hairstyle, hair.look, for_each);
    if (schedule != nullptr) text += ",\"schedule\":" + text_of(schedule_json(*schedule));
    text += ",\"version\":\"" + std::string(kVersion) + "\"";
    if (schedule != nullptr || !warnings.empty()) text += ",\"warnings\":" + text_of(warnings);
    text += "}}";
    return text;
}

}  // namespace

gltf::File hair_bytes(const HairRequest& hair, const HairPlan& plan, Format format, const Context& context,
                      const FileOptions& options) {
    const nlohmann::json clip = plan.motion ? nlohmann::json(schedule_json(plan.motion->schedule)) : nlohmann::json();
    const auto container = format == Format::kGlb ? gltf::Container::kGlb : gltf::Container::kGltf;
    return gltf::hair_file(plan, hair.look, asset_extras(hair, plan, context.for_each),
                           {clip, options.holding, options.kind}, container, options.compression, context.for_each,
                           context.stop);
}

}  // namespace tuftwave::server
