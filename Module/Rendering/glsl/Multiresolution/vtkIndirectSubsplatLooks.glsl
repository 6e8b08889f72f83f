// In moving frames two of a texel's four children look up the depth maps for all of them, because
// look-ups take most time.
const int VTKI_LOOKS = 2;

struct vtkiLooks
{
  vec3 position[VTKI_LOOKS];
  vec3 normal[VTKI_LOOKS];
  bool second[4]; // true if the child takes the second look
};

// Returns the distance of two children, which share a look if it is small. width: squared width of
// neighbours on one surface, which scales the difference of normals to a distance.
float vtkiApart(vec3 position1, vec3 normal1, vec3 position2, vec3 normal2, float width)
{
  vec3 way = position1 - position2;
  vec3 turn = normal1 - normal2;
  return dot(way, way) + 2.0f * width * dot(turn, turn);
}

// The first wanted child looks, and so does the child farthest from it; the others take the nearer
// look.
vtkiLooks vtkiMakeLooks(vec3 position[4], vec3 normal[4], bool wanted[4])
{
  vec3 right = position[1] - position[0];
  vec3 up = position[2] - position[0];
  vec3 rightAbove = position[3] - position[2];
  vec3 upBeside = position[3] - position[1];
  float width = min(min(dot(right, right), dot(up, up)), min(dot(rightAbove, rightAbove), dot(upBeside, upBeside)));
  vtkiLooks looks;
  looks.position[0] = position[3];
  looks.normal[0] = normal[3];
  for (int i = 2; i >= 0; --i)
  {
    looks.position[0] = wanted[i] ? position[i] : looks.position[0];
    looks.normal[0] = wanted[i] ? normal[i] : looks.normal[0];
  }
  looks.position[1] = looks.position[0];
  looks.normal[1] = looks.normal[0];
  float apart[4];
  float most = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    apart[i] = vtkiApart(position[i], normal[i], looks.position[0], looks.normal[0], width);
    bool farther = wanted[i] && apart[i] > most;
    looks.position[1] = farther ? position[i] : looks.position[1];
    looks.normal[1] = farther ? normal[i] : looks.normal[1];
    most = farther ? apart[i] : most;
  }
  for (int i = 0; i < 4; ++i)
  {
    looks.second[i] =
      vtkiApart(position[i], normal[i], looks.position[1], looks.normal[1], width) < apart[i];
  }
  return looks;
}
