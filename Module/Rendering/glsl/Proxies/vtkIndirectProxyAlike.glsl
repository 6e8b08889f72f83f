// How well the light of one receiver serves another.

// The plane's distance, over that of samples, at which a receiver counts half.
const float VTKI_PROXY_DEPTH = 0.5f;

// What a receiver counts that faces elsewhere: power 8 of the cosine, as irradiance is turned to the pixel's normal.
float vtkiProxyFacing(float cosine)
{
  float c = max(cosine, 0.0f);
  float c2 = c * c;
  float c4 = c2 * c2;
  return c4 * c4;
}

// By how far each is from the other's plane, and by normals. distance: between two samples.
float vtkiProxyAlike(vtkiReceiver receiver, vtkiReceiver other, float distance)
{
  vec3 offset = other.positionVC - receiver.positionVC;
  float away = max(abs(dot(offset, receiver.normalVC)), abs(dot(offset, other.normalVC))) /
    max(VTKI_PROXY_DEPTH * distance, 1.0e-30f);
  float away2 = away * away;
  return vtkiProxyFacing(dot(receiver.normalVC, other.normalVC)) / (1.0f + away2 * away2);
}
