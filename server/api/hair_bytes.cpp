#include "api/hair_bytes.hpp"

#include <nlohmann/json.hpp>

#include "api/write_nouns.hpp"
#include "version.hpp"

namespace tuftwave::server {
namespace {

nlohmann::json asset_extras(const HairRequest& hair, const HairPlan& plan) {
    nlohmann::ordered_json extras{{"version", kVersion}, {"hairstyle", hairstyle_json(hair.hairstyle, hair.look)}};
    const Schedule* schedule = plan.motion ? &plan.motion->schedule : nullptr;
    const nlohmann::ordered_json warnings = warnings_json(schedule, plan.fills);
    if (schedule != nullptr) extras["schedule"] = schedule_json(*schedule);
    if (schedule != nullptr || !warnings.empty()) extras["warnings"] = warnings;
    return {{"tuftwave", std::move(extras)}};
}

}  // namespace

std::string hair_bytes(const HairRequest& hair, const HairPlan& plan, Format format, const Context& context,
                       const FileOptions& options) {
    const nlohmann::json clip = plan.motion ? nlohmann::json(schedule_json(plan.motion->schedule)) : nlohmann::json();
    const auto container = format == Format::kGlb ? gltf::Container::kGlb : gltf::Container::kGltf;
    return gltf::hair_file(plan, hair.look, asset_extras(hair, plan), {clip, options.holding, options.kind}, container,
                           context.for_each, context.stop);
}

}  // namespace tuftwave::server
