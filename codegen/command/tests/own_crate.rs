//! Crates of one's own: what is generated, and that nothing of anybody else's is touched.

mod common;

use common::{closedform, fails, repository, succeeds, turn};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// A folder with worksheets in it.
struct Desk(TempDir);

impl Desk {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        fs::create_dir_all(self.path(name).parent().unwrap()).unwrap();
        fs::write(self.path(name), text).unwrap();
    }

    fn arguments(&self, worksheet: &str, out: &str) -> Vec<String> {
        let (input, out) = (self.path(worksheet).display().to_string(), self.path(out).display().to_string());
        ["generate", "--input", &input, "--out", &out].map(str::to_owned).to_vec()
    }

    /// Makes the crate; what was said on standard error, white space folded.
    fn makes(&self, worksheet: &str, out: &str) -> String {
        let arguments = self.arguments(worksheet, out);
        let output = closedform(&repository(), &arguments.iter().map(String::as_str).collect::<Vec<_>>());
        let said = String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(output.status.success(), "{worksheet}: {said}");
        said
    }

    /// Fails to, and changes nothing.
    fn refuses(&self, worksheet: &str, out: &str, words: &[&str]) {
        let arguments = self.arguments(worksheet, out);
        let before = files(self.0.path());
        let said = fails(&repository(), &arguments.iter().map(String::as_str).collect::<Vec<_>>());
        words.iter().for_each(|word| assert!(said.contains(word), "`{word}` is not in {said}"));
        assert_eq!(before, files(self.0.path()), "files changed");
    }

    fn cargo(&self, folder: &str, arguments: &[&str]) {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(arguments).arg("--offline").current_dir(self.path(folder)).env_remove("RUSTFLAGS");
        let output = cargo.env("CARGO_TARGET_DIR", concat!(env!("CARGO_TARGET_TMPDIR"), "/own")).output().unwrap();
        assert!(output.status.success(), "{folder}: {}", String::from_utf8_lossy(&output.stderr));
    }

    fn manifest(&self, out: &str) -> toml::Table {
        fs::read_to_string(self.path(out).join("Cargo.toml")).unwrap().parse().unwrap()
    }
}

/// Every file below a folder with its text.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() && !path.is_symlink() {
            true => found.extend(files(&path)),
            false => _ = found.insert(path.clone(), fs::read(&path).unwrap_or_default()),
        }
    }
    found
}

#[test]
fn the_users_files_are_written_once() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "lens(f,g) := 1/(1/f+1/g)$");
    desk.makes("my.mac", "mine");
    for name in ["Cargo.toml", "src/lib.rs", "README.md", ".gitignore"] {
        let text = fs::read_to_string(desk.path("mine").join(name)).unwrap();
        desk.write(
            &format!("mine/{name}"),
            &format!("{text}# mine\n").replace("# mine", if name.ends_with(".rs") { "// mine" } else { "# mine" }),
        );
    }
    desk.write("mine/src/other.rs", "pub fn precious() -> u32 { 42 }\n");
    let before = files(&desk.path("mine"));
    desk.write("my.mac", "lens(f,g) := 1/(1/f+1/g)$ half(x) := x/2$");
    desk.write("optics.mac", "power(f) := 1/f$");
    desk.makes("my.mac", "mine");
    desk.makes("optics.mac", "mine");
    let after = files(&desk.path("mine"));
    let generated = |path: &Path| path.starts_with(desk.path("mine/src/generated"));
    let users = |files: &BTreeMap<PathBuf, Vec<u8>>| -> BTreeMap<PathBuf, Vec<u8>> {
        files.clone().into_iter().filter(|(path, _)| !generated(path)).collect()
    };
    assert_eq!(users(&before), users(&after), "only src/generated/ is written");
    let index = fs::read_to_string(desk.path("mine/src/generated/mod.rs")).unwrap();
    for kernel in ["my::lens", "my::half", "optics::power"] {
        assert!(index.contains(&format!("&{kernel}::KERNEL")), "{kernel} is not in {index}");
    }
    // Nothing changes at a run that has nothing new.
    desk.makes("optics.mac", "mine");
    assert_eq!(files(&desk.path("mine")), after);
    desk.cargo("mine", &["test", "--quiet"]);
    let formatted =
        Command::new(env!("CARGO")).args(["fmt", "--check"]).current_dir(desk.path("mine")).output().unwrap();
    assert!(formatted.status.success(), "{}", String::from_utf8_lossy(&formatted.stdout));
}

#[test]
fn a_crate_of_somebody_else_gets_src_generated_alone() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "lens(f,g) := 1/(1/f+1/g)$");
    let manifest = "[package]\nname = \"foreign\"\nversion = \"1.2.3\"\nedition = \"2021\"\n\n[dependencies]\n";
    desk.write("foreign/Cargo.toml", manifest);
    desk.write("foreign/src/lib.rs", "pub fn precious() -> u32 { 42 }\n");
    let said = desk.makes("my.mac", "foreign");
    assert!(said.contains("add to src/lib.rs: pub mod generated; pub use generated::*;"), "{said}");
    let (_, line) = said.split_once("add to [dependencies] in Cargo.toml: ").unwrap();
    let (dependency, _) = line.split_once("} ").unwrap();
    assert_eq!(fs::read_to_string(desk.path("foreign/Cargo.toml")).unwrap(), manifest);
    assert_eq!(fs::read_to_string(desk.path("foreign/src/lib.rs")).unwrap(), "pub fn precious() -> u32 { 42 }\n");
    // With what it says, it builds and is judged; and there is nothing to say any more.
    desk.write("foreign/Cargo.toml", &format!("{manifest}{dependency}}}\n"));
    desk.write("foreign/src/lib.rs", "pub mod generated;\npub use generated::*;\npub fn precious() -> u32 { 42 }\n");
    desk.cargo("foreign", &["test", "--quiet"]);
    assert!(!desk.makes("my.mac", "foreign").contains("add to"));
}

#[test]
fn what_was_not_generated_stays() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "f(x) := x$");
    desk.write("file", "words");
    desk.refuses("my.mac", "file", &["is a file"]);
    desk.write("thesis/thesis.tex", "words");
    desk.refuses("my.mac", "thesis", &["holds something else"]);
    desk.write("all/Cargo.toml", "[workspace]\nmembers = []\n");
    desk.refuses("my.mac", "all", &["is a workspace"]);
    desk.write("broken/Cargo.toml", "[package\n");
    desk.refuses("my.mac", "broken", &["is no manifest"]);
    desk.makes("my.mac", "mine");
    for name in ["my.rs", "my.tsv", "mod.rs", "judges.rs"] {
        let path = format!("mine/src/generated/{name}");
        let text = fs::read_to_string(desk.path(&path)).unwrap();
        desk.write(&path, "by hand\n");
        desk.refuses("my.mac", "mine", &["was not generated", name]);
        desk.write(&path, &text);
    }
    desk.makes("my.mac", "mine");
    // Two worksheets whose modules would have one name.
    desk.write("a-b.mac", "f(x) := x$");
    desk.write("a b.mac", "f(x) := 2*x$");
    desk.makes("a-b.mac", "mine");
    let first = fs::read_to_string(desk.path("mine/src/generated/a_b.rs")).unwrap();
    for _ in 0..2 {
        assert!(desk.makes("a b.mac", "mine").contains("called `a_b_2`, because `a_b` is that of another worksheet"));
        assert!(!desk.makes("a-b.mac", "mine").contains("a_b_2"));
    }
    assert_eq!(fs::read_to_string(desk.path("mine/src/generated/a_b.rs")).unwrap(), first);
    assert!(fs::read_to_string(desk.path("mine/src/generated/a_b_2.rs")).unwrap().contains("from a b.mac: edit"));
    // The kernels of a project.
    desk.write("project/Cargo.toml", "[package]\nname = \"kernels\"\n");
    desk.write("project/src/lib.rs", "mod generated;\n");
    desk.write("project/closedform.toml", "kernels = \".\"\n");
    desk.refuses("my.mac", "project", &["belongs to a project"]);
}

#[test]
#[cfg(unix)]
fn links_and_closed_folders_are_refused() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "f(x) := x$");
    desk.makes("my.mac", "mine");
    fs::rename(desk.path("mine/src/generated"), desk.path("elsewhere")).unwrap();
    std::os::unix::fs::symlink(desk.path("elsewhere"), desk.path("mine/src/generated")).unwrap();
    desk.refuses("my.mac", "mine", &["is a link"]);
    std::os::unix::fs::symlink(desk.path("nowhere/at/all"), desk.path("dangling")).unwrap();
    desk.refuses("my.mac", "dangling", &["cannot write"]);
    desk.refuses("my.mac", "my.mac/below", &["cannot write"]);
}

#[test]
fn a_run_that_was_stopped_half_way_is_finished_by_the_next() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "f(x) := x$");
    desk.makes("my.mac", "mine");
    let whole = files(&desk.path("mine"));
    fs::remove_dir_all(desk.path("mine/src")).unwrap();
    desk.makes("my.mac", "mine");
    assert_eq!(files(&desk.path("mine")), whole);
    fs::remove_file(desk.path("mine/src/generated/mod.rs")).unwrap();
    fs::remove_file(desk.path("mine/src/generated/my.tsv")).unwrap();
    desk.makes("my.mac", "mine");
    assert_eq!(files(&desk.path("mine")), whole);
}

#[test]
fn a_crate_of_the_earlier_layout_is_taken_over() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "f(x) := x$");
    desk.write("optics.mac", "power(f) := 1/f$");
    desk.makes("my.mac", "new");
    let mark = "Generated by `closedform generate --input`.";
    let module = fs::read_to_string(desk.path("new/src/generated/my.rs")).unwrap();
    let manifest = fs::read_to_string(desk.path("new/Cargo.toml")).unwrap();
    let manifest = format!("# {mark}\n{}\n[workspace]\n", manifest.split_once('\n').unwrap().1);
    desk.write("old/Cargo.toml", &manifest);
    desk.write("old/src/lib.rs", &format!("// {mark}\n#![no_std]\npub mod my;\n"));
    desk.write("old/src/my.rs", &module);
    desk.write("old/src/other.rs", "// mine\n");
    desk.write("old/tests/judges.rs", &format!("// {mark}\n"));
    assert!(desk.makes("optics.mac", "old").contains("an earlier version generated"));
    assert_eq!(fs::read_to_string(desk.path("old/Cargo.toml")).unwrap(), manifest);
    assert_eq!(fs::read_to_string(desk.path("old/src/generated/my.rs")).unwrap(), module);
    assert!(!desk.path("old/src/my.rs").exists() && desk.path("old/src/other.rs").exists());
    desk.cargo("old", &["test", "--quiet"]);
}

#[test]
fn worksheets_of_any_name_become_modules_that_build() {
    let _turn = turn();
    let desk = Desk::new();
    let names = [
        "lib",
        "core",
        "std",
        "alloc",
        "test",
        "main",
        "fn",
        "my sheet",
        "1digit",
        "closedform",
        "\u{dc}n\u{ef}",
        "a-b.c",
        "mod",
        "generated",
        "judges",
        "self",
        "con",
        "NUL",
        "proc_macro",
        "build",
        "deps",
        "kernels",
    ];
    let long = "long_name_".repeat(20);
    for name in names.into_iter().chain([long.as_str()]) {
        let sheet = format!("{name}.mac");
        desk.write(
            &sheet,
            "f(x) := x+1$ ALL(all) := all/3$ mod(mod) := mod^2$ kernels(kernels) := -kernels$ judges(x) := x$",
        );
        desk.makes(&sheet, "core");
    }
    let names =
        "%alpha(_a,x\\-y) := _a-x\\-y$ \u{65e5}: \u{fc}n\u{ef}^2+a\\?b$ __(Self) := [Self, self/2]$ \\-(f64) := f64^2$";
    desk.write("names.mac", names);
    desk.makes("names.mac", "core");
    assert_eq!(desk.manifest("core")["package"]["name"].as_str(), Some("core-kernels"));
    desk.cargo("core", &["test", "--quiet"]);
}

#[test]
fn a_package_is_called_after_its_folder() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "f(x) := x$");
    assert!(!desk.makes("my.mac", "optics_of-mine").contains("the package is called"));
    assert_eq!(desk.manifest("optics_of-mine")["package"]["name"].as_str(), Some("optics_of-mine"));
    let said = desk.makes("my.mac", "1 crate");
    assert!(said.contains("the package is called `kernels-1-crate`, because `1 crate` is no name for one"), "{said}");
    desk.cargo("1 crate", &["check", "--quiet"]);
}

#[test]
fn workspaces_are_kept_whole() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "f(x) := x$");
    desk.write("space/Cargo.toml", "[workspace]\nresolver = \"3\"\nmembers = [\"crates/*\"]\nexclude = [\"vendor\"]\n");
    assert!(!desk.makes("my.mac", "space/crates/inside").contains("workspace"));
    assert!(!desk.manifest("space/crates/inside").contains_key("workspace"));
    desk.cargo("space", &["test", "--quiet", "--workspace"]);
    assert!(desk.makes("my.mac", "space/beside").contains("does not name this folder among its members"));
    desk.cargo("space/beside", &["check", "--quiet"]);
    desk.makes("my.mac", "space/vendor/out");
    assert!(!desk.manifest("space/vendor/out").contains_key("workspace"));
    desk.cargo("space/vendor/out", &["check", "--quiet"]);
    desk.makes("my.mac", "alone");
    assert!(!desk.manifest("alone").contains_key("workspace"));
    desk.cargo("space", &["check", "--quiet", "--workspace"]);
}

#[test]
fn the_runtime_is_where_one_says() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "f(x) := x$");
    let runtime = |out: &str, place: &str| {
        let mut arguments = desk.arguments("my.mac", out);
        arguments.extend(["--runtime".to_owned(), place.to_owned()]);
        succeeds(&repository(), &arguments.iter().map(String::as_str).collect::<Vec<_>>());
        desk.manifest(out)["dependencies"]["closedform"].clone()
    };
    desk.makes("my.mac", "usual");
    let path = desk.manifest("usual")["dependencies"]["closedform"]["path"].as_str().unwrap().to_owned();
    assert!(path.starts_with("..") && desk.path("usual").join(&path).join("Cargo.toml").exists(), "{path}");
    assert_eq!(runtime("version", "version").as_str(), Some(env!("CARGO_PKG_VERSION")));
    assert_eq!(runtime("git", "https://host/closedform")["git"].as_str(), Some("https://host/closedform"));
    let checkout = repository().display().to_string();
    assert_eq!(runtime("folder", &checkout)["path"].as_str(), Some(&*path));
    // The user's word stays.
    desk.makes("my.mac", "version");
    assert!(desk.manifest("version")["dependencies"]["closedform"].is_str());
}

#[test]
fn two_worksheets_at_once_both_arrive() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("one.mac", "f(x) := x+1$");
    desk.write("two.mac", "g(x) := x+2$");
    let (made, desk) = (["one", "two"], &desk);
    std::thread::scope(|scope| {
        made.iter().for_each(|name| _ = scope.spawn(move || desk.makes(&format!("{name}.mac"), "mine")))
    });
    let index = fs::read_to_string(desk.path("mine/src/generated/mod.rs")).unwrap();
    assert!(index.contains("&one::f::KERNEL") && index.contains("&two::g::KERNEL"), "{index}");
}

#[test]
fn texts_of_strangers_are_shown_letter_by_letter() {
    let _turn = turn();
    let desk = Desk::new();
    desk.write("my.mac", "f(x) := sqrt(x)$");
    let contract = r##"
        [family]
        title = "Forces <b>F</b> [N], f*g*h"
        source = "https://example.org/a_b, page [1]"
        [inputs]
        x = { name = "x", unit = "kg*m/s^2", doc = """
# heading *a*b*
```
[link](x) <i> \\""" }
        [[kernel]]
        name = "f"
        doc = "v0 = k*x*t/1, s[1], _x_ and `code` \\"
        source = "1. [2] *3*"
        branch = "+ a*b*c <x>"
        edges = "tends to Vec<f64>[0] & &lt;"
        inputs = ["x"]
        domain = ["x >= 0\n and x*x*x >= 0"]
        [[kernel.result]]
        name = "f"
        worksheet = "f"
        unit = "N^(1/2)"
    "##;
    desk.write("my.toml", contract);
    desk.makes("my.mac", "mine");
    let list = succeeds(&desk.path("mine"), &["list", "--json"]);
    let list: serde_json::Value = serde_json::from_str(&list).unwrap();
    assert_eq!(list[0]["summary"], "v0 = k*x*t/1, s[1], _x_ and `code` \\");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["doc", "--no-deps", "--offline", "--quiet"]).current_dir(desk.path("mine"));
    cargo.env("CARGO_TARGET_DIR", desk.path("target")).env("RUSTDOCFLAGS", "-Dwarnings");
    let output = cargo.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = fs::read_to_string(desk.path("target/doc/mine/my/fn.f.html")).unwrap();
    for text in
        ["v0 = k*x*t/1, s[1], _x_ and `code` \\", "# heading *a*b* ``` [link](x) &lt;i&gt; \\", "+ a*b*c &lt;x&gt;"]
    {
        assert!(page.contains(text), "{text} is not in {page}");
    }
}
