// Agreement of two receivers: how well the light of one represents the other.

// Distance from the plane, over the distance of samples, at which a receiver's weight is one half.
const float VTKI_PROXY_DEPTH = 0.5f;

// Weight of a receiver of another normal: power 8 of the cosine, because irradiance is evaluated at
// the pixel's normal.
float vtkiProxyFacing(float cosine)
{
  float c = max(cosine, 0.0f);
  float c2 = c * c;
  float c4 = c2 * c2;
  return c4 * c4;
}

// Agreement by the distance of each from the other's plane, and by normals. distance: between two
// samples.
float vtkiProxyAlike(vtkiReceiver receiver, vtkiReceiver other, float distance)
{
  vec3 offset = other.positionVC - receiver.positionVC;
  float away = max(abs(dot(offset, receiver.normalVC)), abs(dot(offset, other.normalVC))) /
    max(VTKI_PROXY_DEPTH * distance, 1.0e-30f);
  float away2 = away * away;
  return vtkiProxyFacing(dot(receiver.normalVC, other.normalVC)) / (1.0f + away2 * away2);
}
