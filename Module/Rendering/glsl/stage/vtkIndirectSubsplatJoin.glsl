// Joins up to four surfaces into the texel above them.
#include "vtkIndirectSubsplat.glsl"
#ifdef VTKI_LIST_SPLIT
#include "vtkIndirectSubsplatStorage.glsl"
#endif

uniform float vtkiPlaneThreshold;  // fraction of the texel's width
uniform float vtkiNormalThreshold; // length of the difference of unit normals
uniform sampler2D vtkiVariation;      // error of interpolation on the coarsest level
uniform float vtkiVariationThreshold; // on this level; negative: not looked at
uniform bool vtkiSplits;           // whether this level may be split
uniform float vtkiEdge;            // pixels along the edge of a texel that is written

struct vtkiJoin
{
  vec3 position[4]; // view coordinates
  vec3 normal[4];
  float deviation[4]; // farthest from the tangent plane, over the child's width
  float spread[4];    // largest difference to the normal
  bool present[4];
  bool split; // what the children ask for
};

// Writes the texel: octahedral normal, depth, state; deviation and spread.
void vtkiWriteJoin(vtkiJoin children, ivec2 texel)
{
  vec3 normal = vec3(0.0f);
  vec3 position = vec3(0.0f);
  float count = 0.0f;
  float nearest = 0.0f;
  float farthest = 0.0f;
  int first = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (children.present[i])
    {
      float depth = -children.position[i].z;
      first = count == 0.0f || depth < nearest ? i : first;
      nearest = count == 0.0f ? depth : min(nearest, depth);
      farthest = count == 0.0f ? depth : max(farthest, depth);
      normal += children.normal[i];
      position += children.position[i];
      count += 1.0f;
    }
  }
  if (count == 0.0f)
  {
    gl_FragData[0] = vec4(0.0f, 0.0f, 0.0f, VTKI_SUBSPLAT_EMPTY);
    gl_FragData[1] = vec4(0.0f);
    return;
  }
  position /= count;
  float norm = length(normal);
  // Opposite normals cancel: the texel is split whatever stands here.
  normal = norm > 0.0f ? normal / norm : children.normal[first];

  float width = vtkiPixelWidth(0.5f * (nearest + farthest)) * vtkiEdge;
  float deviation = 0.0f;
  float spread = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    if (children.present[i])
    {
      // The child's own deviation is in units of its width, half of this one's.
      deviation = max(deviation,
        abs(dot(normal, children.position[i] - position)) / width + 0.5f * children.deviation[i]);
      spread = max(spread, length(children.normal[i] - normal) + children.spread[i]);
    }
  }
  bool split = deviation > vtkiPlaneThreshold || spread > vtkiNormalThreshold ||
    vtkiPlaneThreshold <= 0.0f || vtkiNormalThreshold <= 0.0f;
  vec2 center = vtkiSubsplatCenter(vec2(texel), vtkiEdge, vec2(vtkiSize));
  bool varies = vtkiVariationThreshold >= 0.0f &&
    textureLod(vtkiVariation, 0.5f * center + 0.5f, 0.0f).r > vtkiVariationThreshold;

  vec3 origin = vtkiRayOrigin * vec3(center, 1.0f);
  vec3 direction = vtkiRayDirection * vec3(center, 1.0f);
  float depth;
  if (split)
  {
    // A mixture of surfaces is nowhere; the nearest of them stands for itself.
    normal = children.normal[first];
    depth = vtkiPlaneDepth(normal, children.position[first], origin, direction,
      nearest - width, nearest + width);
  }
  else
  {
    // Where some of the pixels show nothing the centre may lie beyond the others' depths, and must
    // still lie on the plane: behind it is what lights the other side.
    depth = vtkiPlaneDepth(normal, position, origin, direction, 0.5f * nearest, 2.0f * farthest);
  }
  float state = VTKI_SUBSPLAT_WHOLE;
  if (split || varies || children.split)
  {
    state = vtkiSplits ? VTKI_SUBSPLAT_SPLIT
                       : (split ? VTKI_SUBSPLAT_MIXED : VTKI_SUBSPLAT_WHOLE);
#ifdef VTKI_LIST_SPLIT
    if (vtkiSplits)
    {
      vtkiAppend(texel);
    }
#endif
  }
  gl_FragData[0] = vec4(vtkiOctahedralEncode(normal), depth, state);
  gl_FragData[1] = vec4(min(deviation, 60000.0f), spread, 0.0f, 0.0f);
}
