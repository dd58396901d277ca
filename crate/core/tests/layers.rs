//! The structure of the crates: files do not import each other in a cycle, and the core's modules
//! import only lower layers.
//!
//! An import counts for the file that defines the item, also through re-exports. Tests are exempt.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemMod, ItemUse, UseTree, Visibility};

/// Modules of the core from the lowest layer to the highest. A module imports lower layers only.
const LAYERS: [&[&str]; 7] = [
    &["foot", "intervals", "notice", "numeric", "registry"],
    &["bvh"],
    &["kinematics"],
    &["skeleton"],
    &["plants", "points", "segments"],
    &["gait", "score", "skate"],
    &["formats"],
];

/// Path of a module within its crate; empty for the root.
type Module = Vec<String>;

/// Paths that one file names.
#[derive(Default)]
struct Paths {
    /// Paths in code and in private imports.
    used: Vec<Module>,
    /// Re-exported paths with the names under which they are exported.
    exported: Vec<(String, Module)>,
}

impl Paths {
    fn add_tree(&mut self, tree: &UseTree, prefix: &Module, is_export: bool) {
        let extended = |name: &dyn ToString| [prefix.as_slice(), &[name.to_string()]].concat();
        match tree {
            UseTree::Path(path) => self.add_tree(&path.tree, &extended(&path.ident), is_export),
            UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.add_tree(tree, prefix, is_export));
            }
            UseTree::Name(name) if name.ident == "self" => self.used.push(prefix.clone()),
            UseTree::Name(name) => self.add(extended(&name.ident), name.ident.to_string(), is_export),
            UseTree::Rename(rename) => {
                self.add(extended(&rename.ident), rename.rename.to_string(), is_export);
            }
            UseTree::Glob(_) => self.used.push(prefix.clone()),
        }
    }

    fn add(&mut self, path: Module, name: String, is_export: bool) {
        if is_export {
            self.exported.push((name, path));
        } else {
            self.used.push(path);
        }
    }
}

impl<'ast> Visit<'ast> for Paths {
    fn visit_item_mod(&mut self, module: &'ast ItemMod) {
        if !is_test(&module.attrs) {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        let is_export = !matches!(item.vis, Visibility::Inherited);
        self.add_tree(&item.tree, &Module::new(), is_export);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.segments.len() > 1 {
            self.used.push(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        }
        visit::visit_path(self, path);
    }

    /// Macros are opaque to the parser: their paths are found by text.
    fn visit_macro(&mut self, mac: &'ast syn::Macro) {
        let text = mac.tokens.to_string().replace(" :: ", "::");
        let words = text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
        self.used.extend(words.filter(|word| word.contains("::")).map(|word| {
            word.split("::").filter(|name| !name.is_empty()).map(str::to_owned).collect::<Module>()
        }));
        visit::visit_macro(self, mac);
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.meta.require_list().is_ok_and(|list| list.tokens.to_string() == "test")
    })
}

/// Files of a crate by module, with the paths that they name.
struct Crate(BTreeMap<Module, Paths>);

impl Crate {
    fn read(source: &Path) -> Crate {
        let mut files = Vec::new();
        collect(source, &mut files);
        let mut modules = BTreeMap::new();
        let mut tests = BTreeSet::new();
        for file in files {
            let relative = file.strip_prefix(source).expect("inside").with_extension("");
            let mut module: Module =
                relative.iter().map(|part| part.to_string_lossy().into_owned()).collect();
            module.pop_if(|last| ["mod", "lib", "main"].contains(&last.as_str()));
            let text = fs::read_to_string(&file).expect("a source file");
            let parsed = syn::parse_file(&text).expect("Rust");
            for item in &parsed.items {
                if let Item::Mod(child) = item
                    && is_test(&child.attrs)
                {
                    tests.insert([module.as_slice(), &[child.ident.to_string()]].concat());
                }
            }
            let mut paths = Paths::default();
            paths.visit_file(&parsed);
            modules.insert(module, paths);
        }
        modules.retain(|module, _| !tests.iter().any(|test| module.starts_with(test)));
        Crate(modules)
    }

    /// Returns the module that defines the item of a path in `module`; `None` if it is in another crate.
    fn resolve(&self, module: &Module, path: &[String]) -> Option<Module> {
        let (mut current, mut rest) = match path.first()?.as_str() {
            "crate" => (Module::new(), &path[1..]),
            "self" => (module.clone(), &path[1..]),
            "super" => {
                let levels = path.iter().take_while(|name| *name == "super").count();
                (module[..module.len().checked_sub(levels)?].to_vec(), &path[levels..])
            }
            name if self.0.contains_key(&[module.as_slice(), &[name.into()]].concat()) => {
                (module.clone(), path)
            }
            _ => return None,
        };
        while let Some(name) = rest.first() {
            let child = [current.as_slice(), std::slice::from_ref(name)].concat();
            if self.0.contains_key(&child) {
                (current, rest) = (child, &rest[1..]);
                continue;
            }
            let exported = &self.0.get(&current)?.exported;
            return match exported.iter().find(|(exported, _)| exported == name) {
                Some((_, path)) => self.resolve(&current, &[path.as_slice(), &rest[1..]].concat()),
                None => Some(current),
            };
        }
        Some(current)
    }

    /// Returns the modules that each module imports.
    fn imports(&self) -> BTreeMap<&Module, BTreeSet<Module>> {
        let of_module = |(module, paths): (_, &Paths)| {
            let resolved = paths.used.iter().filter_map(|path| self.resolve(module, path));
            (module, resolved.filter(|other| other != module).collect())
        };
        self.0.iter().map(of_module).collect()
    }
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// Returns a cycle of imports as module names, if there is one.
fn cycle(imports: &BTreeMap<&Module, BTreeSet<Module>>) -> Option<Vec<String>> {
    fn visit<'a>(
        module: &'a Module,
        imports: &'a BTreeMap<&Module, BTreeSet<Module>>,
        open: &mut Vec<&'a Module>,
        done: &mut BTreeSet<&'a Module>,
    ) -> Option<Vec<String>> {
        if let Some(start) = open.iter().position(|other| *other == module) {
            return Some(open[start..].iter().map(|module| module.join("::")).collect());
        }
        if !done.insert(module) {
            return None;
        }
        open.push(module);
        let found = imports[module].iter().find_map(|other| visit(other, imports, open, done));
        open.pop();
        found
    }
    let mut done = BTreeSet::new();
    imports.keys().find_map(|module| visit(module, imports, &mut Vec::new(), &mut done))
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn files_do_not_import_each_other_in_a_cycle() {
    for entry in fs::read_dir(workspace()).expect("the crates") {
        let source = entry.expect("a crate").path().join("src");
        if source.is_dir() {
            let crate_ = Crate::read(&source);
            assert_eq!(cycle(&crate_.imports()), None, "cycle of imports in {}", source.display());
        }
    }
}

#[test]
fn modules_import_lower_layers_only() {
    let core = Crate::read(&workspace().join("core/src"));
    let layer = |module: &Module| {
        let name = module.first()?;
        let layer = LAYERS.iter().position(|names| names.contains(&name.as_str()));
        Some((layer.unwrap_or_else(|| panic!("{name} has no layer")), name.clone()))
    };
    let mut count = 0;
    for (module, others) in core.imports() {
        let Some((own, name)) = layer(module) else { continue };
        for other in &others {
            let Some((lower, other_name)) = layer(other) else {
                panic!("{} imports the root of the crate", module.join("::"));
            };
            let is_lower = lower < own || other_name == name;
            assert!(is_lower, "{} imports {}", module.join("::"), other.join("::"));
            count += 1;
        }
    }
    assert!(count > 200, "only {count} imports were found");
}
