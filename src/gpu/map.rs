//! A map of some dozen entries, searched from front to back. It has the methods of `HashMap` that backends
//! use, in a tenth of the code, which browsers download; comparing the few keys that a frame draws with costs
//! less than hashing.

/// See the [module](self).
pub struct Map<K, V>(Vec<(K, V)>);

impl<K: PartialEq, V> Map<K, V> {
    /// An empty map.
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// The number of entries.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// The value of a key.
    pub fn get(&self, key: &K) -> Option<&V> {
        self.0.iter().find(|(k, _)| k == key).map(|(_, v)| v)
    }

    /// Whether a key has a value.
    #[cfg(feature = "wgpu")]
    pub fn contains_key(&self, key: &K) -> bool {
        self.get(key).is_some()
    }

    /// Adds an entry whose key is not there yet.
    pub fn insert(&mut self, key: K, value: V) {
        debug_assert!(self.get(&key).is_none(), "a key has one value");
        self.0.push((key, value));
    }

    /// Keeps the entries that `keep` accepts, in their order.
    pub fn retain(&mut self, mut keep: impl FnMut(&K, &V) -> bool) {
        self.0.retain(|(k, v)| keep(k, v));
    }

    /// All values.
    #[cfg(feature = "webgl")]
    pub fn values(&self) -> impl Iterator<Item = &V> {
        self.0.iter().map(|(_, v)| v)
    }
}

#[cfg(test)]
mod tests {
    use super::Map;

    #[test]
    fn a_map_finds_and_forgets_by_key() {
        let mut map = Map::new();
        for key in 0..20 {
            map.insert(key, key * key);
        }
        map.retain(|key, _| key % 3 != 0);
        let found: Vec<_> = (0..20).filter_map(|key| map.get(&key).copied()).collect();
        assert_eq!(found, [1, 4, 16, 25, 49, 64, 100, 121, 169, 196, 256, 289, 361]);
        assert_eq!(map.len(), found.len());
    }
}
