// The cell of a cumulative distribution that u falls into: the last one that starts at or below u. The count + 1 floats
// from a word on begin with 0 and end with 1.
int findCell(int cdf, int count, float u) {
  int low = 0;
  int high = count - 1;
  while (low < high) {
    int middle = (low + high + 1) / 2;
    if (loadFloat(cdf + middle) <= u) low = middle;
    else high = middle - 1;
  }
  return low;
}
