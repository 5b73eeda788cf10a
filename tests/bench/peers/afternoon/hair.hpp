#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

/// What a good C++ programmer writes in an afternoon for the same answers: glm, push_back, tinygltf, ostringstream.
namespace afternoon {

constexpr int kRings = 64, kSides = 12;
constexpr float kWidest = 0.02F;  ///< radius, metres

struct Mesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uvs;
    std::vector<unsigned> indices;
};

using Points = std::vector<glm::vec3>;

/// Adds a tube along a smooth curve through the points: thin at both ends, frames carried from ring to ring.
void add_tube(Mesh& mesh, const Points& points);

/// All chains of a motion: picture n, chain c, bone i at [n][c][i], local rotations.
using Poses = std::vector<std::vector<std::vector<glm::quat>>>;

/// The travelling wave along each chain as bone rotations about one axis, their mean over the pictures taken out.
Poses move(const std::vector<Points>& chains, int pictures);

/// One mesh as a GLB. @return  the file
std::string mesh_file(const Mesh& mesh);

/// Chains as nodes and their poses as a clip with STEP keys. @param hold  frames per picture @param fps  frames per s
std::string clip_file(const std::vector<Points>& chains, const Poses& poses, int hold, float fps);

}  // namespace afternoon
