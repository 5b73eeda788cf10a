/**
 * GLSL for vertex shaders: where a vertex of hair lies in the picture that is shown. Under POSED only.
 * Attributes: `joints`, four numbers of joints among all tufts', `weights`, theirs, whose sum is 1, and `mark`, how much of the accent is
 * mixed in. Uniforms: PoseTexture's.
 */
export const kPosingGlsl = /* glsl */ `
#ifdef POSED
  attribute vec4 joints;
  attribute vec4 weights;
  uniform highp sampler2D poses;
  uniform int poseJoints;
  uniform int posePictures;
  uniform float picture;
  attribute float mark;

  mat4 jointPose(int joint, int shown) {
    int width = textureSize(poses, 0).x;
    int at = 3 * (shown * poseJoints + joint);
    vec4 rows[3];
    for (int i = 0; i < 3; i++) rows[i] = texelFetch(poses, ivec2((at + i) % width, (at + i) / width), 0);
    return transpose(mat4(rows[0], rows[1], rows[2], vec4(0.0, 0.0, 0.0, 1.0)));
  }

  mat4 skinPose(int shown) {
    mat4 sum = mat4(0.0);
    for (int i = 0; i < 4; i++) {
      if (weights[i] > 0.0) sum += weights[i] * jointPose(int(joints[i] + 0.5), shown);
    }
    return sum;
  }

  mat4 poseMatrix() {
    if (picture < 0.0 || posePictures == 0) return mat4(1.0);
    int shown = int(picture) % posePictures;
    float share = fract(picture);
    mat4 pose = skinPose(shown);
    if (share > 0.0) pose = (1.0 - share) * pose + share * skinPose((shown + 1) % posePictures);
    return pose;
  }
#endif`;
