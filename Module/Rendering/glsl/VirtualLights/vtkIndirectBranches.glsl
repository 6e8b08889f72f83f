// Nodes of a tree below virtual lights: a receiver that is near to a light sums these in its place
// (vtkLightTreeSampler).
#include "vtkIndirectLightRow.glsl"

uniform sampler2D vtkiBranchPosition; // as of virtual lights; see vtkIndirectLibTable.glsl for their order
uniform sampler2D vtkiBranchNormal;
uniform sampler2D vtkiBranchDensity;

// Share of a light that comes from the nodes below it: all within eight tenths of its reach, none beyond it.
float vtkiDivision(vec3 toSender, float reach)
{
  float reach2 = max(reach * reach, 1.0e-30f);
  return clamp((reach2 - dot(toSender, toSender)) / (0.36f * reach2), 0.0f, 1.0f);
}

void vtkiFetchBranch(int entry, out vec4 sender, out vec4 senderNormal, out vec3 density)
{
  ivec2 at = vtkiTableTexel(entry);
  sender = texelFetch(vtkiBranchPosition, at, 0);
  senderNormal = texelFetch(vtkiBranchNormal, at, 0);
  density = texelFetch(vtkiBranchDensity, at, 0).rgb;
}

// Irradiance, and the luminance of the vector irradiance, of a node's share.
void vtkiAddNode(vec3 position, vec3 normal, float share, vec4 sender, vec3 senderNormal, vec3 density,
  inout vec3 irradiance, inout vec3 vectorIrradiance)
{
  vec3 toSender = sender.xyz - position;
  float cosine = dot(normal, toSender);
  float strength =
    cosine > 0.0f ? share * vtkiVirtualLightStrength(toSender, senderNormal, sender.w) : 0.0f;
  irradiance += (strength * cosine) * density;
  vectorIrradiance +=
    (strength * dot(density, vec3(0.2126f, 0.7152f, 0.0722f))) * toSender;
}

// What is below a light, for one receiver. share: of what comes of these; 0: nothing is done.
void vtkiAddBranches(int light, vec3 position, vec3 normal, float share, inout vec3 irradiance,
  inout vec3 vectorIrradiance)
{
  int children = share > 0.0f ? VTKI_BRANCHES_PER_NODE : 0;
  for (int child = 0; child < children; ++child)
  {
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    int entry = VTKI_BRANCHES * light + child;
    vtkiFetchBranch(entry, sender, senderNormal, density);
    float division = vtkiDivision(sender.xyz - position, senderNormal.w);
    vtkiAddNode(position, normal, share * (1.0f - division), sender, senderNormal.xyz, density, irradiance,
      vectorIrradiance);
    int leaves = division > 0.0f ? VTKI_BRANCHES_PER_NODE : 0;
    int first = VTKI_BRANCHES * light + VTKI_BRANCHES_PER_NODE * (1 + child);
    for (int leaf = 0; leaf < leaves; ++leaf)
    {
      vtkiFetchBranch(first + leaf, sender, senderNormal, density);
      vtkiAddNode(position, normal, share * division, sender, senderNormal.xyz, density, irradiance,
        vectorIrradiance);
    }
  }
}
