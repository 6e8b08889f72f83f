// Branches of virtual lights (vtkLightTreeSampler): a receiver near to a cluster sums its branches
// instead of the cluster. Clusters are summed as a whole first, VTKI_NEAR_LIGHTS at a time; a bit
// set keeps the near ones, whose branches are walked afterwards. Walking them in the first loop
// would take as long for receivers that are far, where groups of receivers run through a loop
// together.
#include "vtkIndirectLightRow.glsl"

const int VTKI_NEAR_LIGHTS = 128;

// as the virtual lights' table; see vtkIndirectLibTable.glsl for the order
uniform sampler2D vtkiBranchPosition;
uniform sampler2D vtkiBranchNormal;
uniform sampler2D vtkiBranchDensity;

uniform float vtkiChildDistanceScale; // times the child distances of nodes above leaves

// Share of a cluster's light that comes from its branches: all within eight tenths of its child distance,
// none beyond it.
float vtkiDivision(float distance2, float childDistance)
{
  float childDistance2 = max(childDistance * childDistance, 1.0e-30f);
  return clamp((childDistance2 - distance2) / (0.36f * childDistance2), 0.0f, 1.0f);
}

// Returns false if no part of a node lights a receiver, so that the nodes below need no walk: on a
// wall the nearest nodes are those of the wall. The node has the receiver's normal, and its place lies
// behind the receiver's plane, so that parts before the plane would face away. Normals that differ
// count as a tilt, by which parts rise over the plane; the extent of a node counts as eight times
// the child distance, since its parts may be scattered.
bool vtkiMayLight(vec3 normal, vec3 toSender, vec3 senderNormal, float childDistance)
{
  float along = dot(normal, senderNormal);
  float sine = sqrt(max(1.0f - along * along - 1.0e-5f, 0.0f));
  return along <= 0.0f || dot(normal, toSender) > childDistance * (1.0e-3f - 8.0f * sine);
}

// A cluster that reaches through a receiver's plane may have its place behind the plane. Its depth
// map does not show what is before the plane, such as the edge of a ceiling before a hanging sheet.
// The other near clusters before the plane decide how much of the branches there the receiver sees:
// all if it sees a quarter of these clusters or if there are none, and nothing in a closed body.
struct vtkiSight
{
  float seen; // part of `all` that the receiver sees
  float all;  // near clusters before the plane, each with both cosines and its division
};

const float VTKI_ENOUGH_SIGHT = 0.25f;
// This is the weight of a guess that nothing is hidden, beside up to 1 for a cluster. With 0.01 a
// closed ball has a third less light inside, and errors in rooms and folds are 3 % larger.
const float VTKI_UNHIDDEN = 0.06f;

vtkiSight vtkiReceiverSight; // of the receiver whose light is summed

void vtkiStartSight()
{
  vtkiReceiverSight = vtkiSight(0.0f, 0.0f);
}

// Returns the share of a cluster's branches that a receiver sees. seen: share by the cluster's
// depth map.
float vtkiShareOfBranches(vtkiSight sight, vec3 facet, vec3 toSender, float seen)
{
#ifdef VTKI_DEPTH_TILES
  float before =
    min((sight.seen / VTKI_ENOUGH_SIGHT + VTKI_UNHIDDEN) / (sight.all + VTKI_UNHIDDEN), 1.0f);
  return dot(facet, toSender) < 0.0f ? before : seen;
#else
  return seen;
#endif
}

// vtkiDivision of a node above leaves; 0 for a node that gives the receiver nothing.
float vtkiDivisionOfChild(vec3 normal, vec3 toSender, vec3 senderNormal, float childDistance)
{
  return vtkiMayLight(normal, toSender, senderNormal, childDistance)
    ? vtkiDivision(dot(toSender, toSender), vtkiChildDistanceScale * childDistance)
    : 0.0f;
}

// Keeps what a receiver sees of a cluster. Returns true if the cluster's branches are to be added.
// seen: share by the cluster's depth map.
bool vtkiKeepSight(inout vtkiSight sight, vec3 facet, vec3 normal, vec3 toSender, vec4 senderNormal, float division,
  float seen)
{
  float height = max(dot(facet, toSender), 0.0f);
  float cosines = height * max(-dot(senderNormal.xyz, toSender), 0.0f) / max(dot(toSender, toSender), 1.0e-30f);
  sight.seen += seen * division * cosines;
  sight.all += division * cosines;
  return division * vtkiShareOfBranches(sight, facet, toSender, seen) > 0.0f &&
    vtkiMayLight(normal, toSender, senderNormal.xyz, senderNormal.w);
}

// A light's bit in a set.
uvec4 vtkiLightBit(int light)
{
  uint bit = 1u << uint(light & 31);
  int word = light >> 5;
  return uvec4(word == 0 ? bit : 0u, word == 1 ? bit : 0u, word == 2 ? bit : 0u, word == 3 ? bit : 0u);
}

void vtkiKeepNear(inout uvec4 near, int light, bool isNear)
{
  near |= isNear ? vtkiLightBit(light) : uvec4(0u);
}

bool vtkiHasNear(uvec4 near)
{
  return (near.x | near.y | near.z | near.w) != 0u;
}

// Removes the first light from the set and returns its number.
int vtkiTakeNear(inout uvec4 near)
{
  int word = near.x != 0u ? 0 : (near.y != 0u ? 1 : (near.z != 0u ? 2 : 3));
  uint bits = word == 0 ? near.x : (word == 1 ? near.y : (word == 2 ? near.z : near.w));
  uint lowest = bits & (~bits + 1u);
  near &= ~uvec4(word == 0 ? lowest : 0u, word == 1 ? lowest : 0u, word == 2 ? lowest : 0u,
    word == 3 ? lowest : 0u);
  // log2 of a power of two may be off by rounding, which the 0.5 absorbs.
  return 32 * word + int(log2(float(lowest)) + 0.5f);
}

// Next place of the walk through a cluster's branches: a child if below is set, otherwise the next
// branch. A negative child distance ends the siblings: neither this place nor those after it hold one.
int vtkiNextBranch(int place, float childDistance, bool below)
{
  const int family = VTKI_BRANCHES_PER_NODE + 1;
  int afterwards = (place / family + 1) * family;
  bool isChild = place % family == 0;
  int past = isChild && childDistance < 0.0f ? VTKI_BRANCHES : afterwards;
  return childDistance >= 0.0f && (below || !isChild) ? place + 1 : past;
}

bool vtkiIsChild(int place)
{
  return place % (VTKI_BRANCHES_PER_NODE + 1) == 0;
}

void vtkiFetchBranch(int light, int place, out vec4 sender, out vec4 senderNormal, out vec4 density)
{
  ivec2 at = vtkiTableTexel(VTKI_BRANCHES * light + place);
  sender = texelFetch(vtkiBranchPosition, at, 0);
  senderNormal = texelFetch(vtkiBranchNormal, at, 0);
  density = texelFetch(vtkiBranchDensity, at, 0);
}
