//! The files by which the library is built and found: `Cargo.toml`, CMake's, pkg-config's.

use super::names::Names;
use crate::package::Package;
use std::path::Path;

const MANIFEST: &str = include_str!("../../template/c/manifest.txt");
const CMAKE: &str = include_str!("../../template/c/cmake.txt");
const PKG_CONFIG: &str = include_str!("../../template/c/pkg_config.txt");

/// The manifest of the binding crate; `kernels` is the way to the crate of the kernels.
pub fn manifest(package: &Package, names: &Names, kernels: &Path) -> String {
    let path = toml::Value::from(kernels.to_string_lossy().replace('\\', "/")).to_string();
    let std = if package.has_std { format!("\"{}/std\"", package.name) } else { String::new() };
    MANIFEST
        .replace("@PACKAGE@", &package.name)
        .replace("@LIBRARY@", &names.library)
        .replace("@PATH@", &path)
        .replace("@STD@", &std)
}

/// `CMakeLists.txt`.
pub fn cmake(names: &Names) -> String {
    CMAKE.replace("@LIBRARY@", &names.library).replace("@PREFIX@", &names.prefix)
}

/// The file of pkg-config.
pub fn pkg_config(package: &Package, names: &Names) -> String {
    PKG_CONFIG.replace("@LIBRARY@", &names.library).replace("@PACKAGE@", &package.name)
}
