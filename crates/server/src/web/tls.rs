//! Encryption: the certificate that is given, or one that this computer writes for itself.

use rcgen::{CertificateParams, KeyPair};
use sha2::{Digest, Sha256};
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::os::unix::fs::OpenOptionsExt;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tokio_rustls::TlsAcceptor;
use tokio_rustls::rustls::ServerConfig;
use tokio_rustls::rustls::crypto::ring::default_provider;
use tokio_rustls::rustls::pki_types::pem::PemObject;
use tokio_rustls::rustls::pki_types::{CertificateDer, PrivateKeyDer};

/// Where certificate and key come from.
#[derive(Clone, Debug)]
pub enum Certificate {
    /// PEM files: the chain, and its private key.
    Files {
        /// The chain.
        chain: PathBuf,
        /// The key.
        key: PathBuf,
    },
    /// One that nobody else vouches for, kept in this folder, so that a browser meets the same again; without a folder
    /// a new one each time.
    Own(Option<PathBuf>),
}

/// A certificate or key that cannot be used: the file, and why.
#[derive(Debug)]
pub struct Unusable {
    /// The file.
    pub file: PathBuf,
    /// Why.
    pub reason: String,
}

/// Files of a certificate of one's own.
const CHAIN: &str = "panel-certificate.pem";
const KEY: &str = "panel-key.pem";

/// What encrypts connections, and the SHA-256 of the certificate, by which people know it.
pub(super) struct Encryption {
    pub acceptor: TlsAcceptor,
    pub fingerprint: String,
}

/// Reads or makes a certificate for the names that this computer has.
pub(super) fn open(certificate: &Certificate, names: &[String]) -> Result<Encryption, Unusable> {
    match certificate {
        Certificate::Files { chain, key } => read(chain, key),
        Certificate::Own(None) => {
            let file = || PathBuf::from("--tls-self-signed");
            let (chain, key) =
                make(names).map_err(|error| Unusable { file: file(), reason: error.to_string() })?;
            of_pem(chain.as_bytes(), key.as_bytes()).map_err(|reason| Unusable { file: file(), reason })
        }
        Certificate::Own(Some(folder)) => {
            let (chain, key) = (folder.join(CHAIN), folder.join(KEY));
            if !chain.exists() || !key.exists() {
                let unusable =
                    |error: &dyn ToString| Unusable { file: chain.clone(), reason: error.to_string() };
                let (chain_text, key_text) = make(names).map_err(|error| unusable(&error))?;
                write(&key, &key_text, 0o600).map_err(|error| unusable(&error))?;
                write(&chain, &chain_text, 0o644).map_err(|error| unusable(&error))?;
            }
            read(&chain, &key)
        }
    }
}

fn make(names: &[String]) -> Result<(String, String), rcgen::Error> {
    let key = KeyPair::generate()?;
    let own = ["localhost", "127.0.0.1", "::1"].map(str::to_owned);
    let params = CertificateParams::new(own.into_iter().chain(names.iter().cloned()).collect::<Vec<_>>())?;
    Ok((params.self_signed(&key)?.pem(), key.serialize_pem()))
}

/// Never readable by others, not even for a moment.
fn write(path: &Path, text: &str, mode: u32) -> io::Result<()> {
    let _ = fs::remove_file(path);
    let mut file = OpenOptions::new().write(true).create_new(true).mode(mode).open(path)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()
}

fn read(chain: &Path, key: &Path) -> Result<Encryption, Unusable> {
    let bytes = |file: &Path| {
        fs::read(file).map_err(|error| Unusable { file: file.to_owned(), reason: error.to_string() })
    };
    of_pem(&bytes(chain)?, &bytes(key)?).map_err(|reason| Unusable { file: chain.to_owned(), reason })
}

fn of_pem(chain: &[u8], key: &[u8]) -> Result<Encryption, String> {
    let chain: Result<Vec<CertificateDer>, _> = CertificateDer::pem_slice_iter(chain).collect();
    let chain = chain.map_err(|error| error.to_string())?;
    let first = chain.first().ok_or("it has no certificate")?;
    let fingerprint =
        Sha256::digest(first).iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(":");
    let key = PrivateKeyDer::from_pem_slice(key).map_err(|error| error.to_string())?;
    let config = ServerConfig::builder_with_provider(Arc::new(default_provider()))
        .with_safe_default_protocol_versions()
        .and_then(|config| config.with_no_client_auth().with_single_cert(chain, key));
    let mut config = config.map_err(|error| error.to_string())?;
    config.alpn_protocols = vec![b"http/1.1".to_vec()];
    Ok(Encryption { acceptor: TlsAcceptor::from(Arc::new(config)), fingerprint })
}
