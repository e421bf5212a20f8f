//! What a backend holds, found by ids that mean nothing on any other backend. For backends: users of one have
//! the ids alone.

use std::marker::PhantomData;

use crate::error::{Error, Result};

/// An id: the number of the backend that gave it ([`Backend::epoch`](super::Backend::epoch)), and a number
/// there that is not given again.
pub trait Id: Copy {
    /// What it names, in an error.
    const WHAT: &'static str;
    /// An id of its parts.
    fn new(epoch: u32, key: u32) -> Self;
    /// The parts of an id.
    fn parts(self) -> (u32, u32);
}

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident, $what:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name {
            epoch: u32,
            key: u32,
        }

        impl arena::Id for $name {
            const WHAT: &'static str = $what;

            fn new(epoch: u32, key: u32) -> Self {
                Self { epoch, key }
            }

            fn parts(self) -> (u32, u32) {
                (self.epoch, self.key)
            }
        }
    )*};
}
pub(super) use ids;

/// See the [module](self).
pub struct Arena<I, T> {
    backend: &'static str,
    epoch: u32,
    next: u32,
    /// In the order of their keys.
    items: Vec<(u32, T)>,
    ids: PhantomData<I>,
}

impl<I: Id, T> Arena<I, T> {
    /// An empty arena of a backend, by its name and epoch.
    pub fn new(backend: &'static str, epoch: u32) -> Self {
        Self { backend, epoch, next: 0, items: Vec::new(), ids: PhantomData }
    }

    /// Where the thing of an id is.
    fn index(&self, id: I) -> Option<usize> {
        let (epoch, key) = id.parts();
        if epoch != self.epoch {
            return None;
        }
        self.items.iter().position(|(known, _)| *known == key)
    }

    /// Takes something in.
    pub fn insert(&mut self, item: T) -> I {
        let key = self.next;
        self.next += 1;
        self.items.push((key, item));
        I::new(self.epoch, key)
    }

    /// What an id names, if it is still there.
    pub fn get(&self, id: I) -> Option<&T> {
        Some(&self.items[self.index(id)?].1)
    }

    /// As [`Self::get`], to be changed.
    pub fn get_mut(&mut self, id: I) -> Option<&mut T> {
        let index = self.index(id)?;
        Some(&mut self.items[index].1)
    }

    /// What an id names.
    ///
    /// # Errors
    /// [`crate::ErrorKind::Driver`] that says whether it is gone or was never here.
    pub fn find(&self, id: I) -> Result<&T> {
        self.get(id).ok_or_else(|| self.unknown(id))
    }

    /// Takes out what an id names.
    pub fn remove(&mut self, id: I) -> Option<T> {
        let index = self.index(id)?;
        Some(self.items.remove(index).1)
    }

    /// Keeps the things that `keep` accepts.
    pub fn retain(&mut self, mut keep: impl FnMut(&T) -> bool) {
        self.items.retain(|(_, item)| keep(item));
    }

    /// The number of things.
    pub fn len(&self) -> usize {
        self.items.len()
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// All things.
    pub fn values(&self) -> impl Iterator<Item = &T> {
        self.items.iter().map(|(_, item)| item)
    }

    /// The id of the first thing that `is` accepts.
    pub fn position(&self, is: impl Fn(&T) -> bool) -> Option<I> {
        self.items.iter().find(|(_, item)| is(item)).map(|(key, _)| I::new(self.epoch, *key))
    }

    /// Why an id names nothing here.
    #[cold]
    pub fn unknown(&self, id: I) -> Error {
        unknown(self.backend, I::WHAT, id.parts().0 == self.epoch)
    }
}

/// One copy in the program, however many kinds of things there are.
#[inline(never)]
fn unknown(backend: &'static str, what: &str, is_own: bool) -> Error {
    let reason = if is_own {
        "no such object: it was destroyed"
    } else {
        "no such object: it belongs to another backend"
    };
    Error::driver(backend, what, reason)
}

#[cfg(test)]
mod tests {
    use super::super::TextureId;
    use super::*;

    #[test]
    fn ids_of_another_backend_find_nothing_and_say_so() {
        let [mut a, mut b] = [1, 2].map(|epoch| Arena::<TextureId, u32>::new("test", epoch));
        let (in_a, in_b) = (a.insert(10), b.insert(20));
        assert_ne!(in_a, in_b);
        assert_eq!((a.get(in_a), b.get(in_b), a.get(in_b), b.get(in_a)), (Some(&10), Some(&20), None, None));
        assert!(b.remove(in_a).is_none() && b.get_mut(in_a).is_none() && b.len() == 1);
        assert!(a.unknown(in_b).to_string().ends_with("another backend"), "{}", a.unknown(in_b));
        assert_eq!((a.remove(in_a), a.len()), (Some(10), 0));
        assert!(a.find(in_a).unwrap_err().to_string().ends_with("it was destroyed"));
    }
}
