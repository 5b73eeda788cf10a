#pragma once

#include <string>
#include <vector>

#include "gltf/hair_file.hpp"
#include "tuftwave/hairstyle.hpp"
#include "workloads.hpp"

/// What the service does once it has read a request, measured without a socket.
namespace tuftwave::bench {

/// Which measurements a run of the program makes. The first three need a process of their own: they are about memory
/// that nobody has used yet. The others are warm.
void measure_first(const Workloads& workloads);
void measure_many(const Workloads& workloads);
void measure_pack_memory(const Workloads& workloads);
void measure_hair(const Workloads& workloads);
void measure_motion(const Workloads& workloads);
void measure_reading(const Workloads& workloads);
void measure_packing(const Workloads& workloads);
void measure_fill(const Workloads& workloads);
void measure_meshopt(const Workloads& workloads);

/// W1 with so many of its strokes, again and again from the first one; 64 rings, 12 sides.
Hairstyle hair_of(const Workloads& workloads, std::size_t strokes);

/// Merged; and without a skin, where a look or a mesh can say so.
server::gltf::Look merged_look();

/// More than any request may ask for.
Limits no_limits();

/// The GLB of a hairstyle: planned, meshed and packed. @param for_each  who works
server::gltf::File hair_glb(const Hairstyle& hairstyle, const server::gltf::Look& look, const ForEach& for_each,
                            server::gltf::Compression compression = server::gltf::Compression::kNone);

/// What the service does with an answer once it has been sent: its buffer is for the next one.
void sent(server::gltf::File file);

/// W2's chains as core has them.
std::vector<Chain> chains_of(const Workloads& workloads);

/// A second at 24 frames per second. @param hold  frames per picture
Motion motion_of(int hold);

/// The motion as POST /v1/motions computes it.
HairMotion moved(const std::vector<Chain>& chains, const Motion& motion);

}  // namespace tuftwave::bench
